// Starts the page that the script stands on. `explore.page` is what the tests drive.
(() => {
    const { page } = document.currentScript.dataset;
    if (window.parent !== window) document.documentElement.classList.add('embedded'); // within a page of the chapter
    const files = {
        machine: 'machine.js',
        plane: 'plane.js',
        printed: 'printed_page.js',
        integrators: 'integrators.js',
        digits: 'digits_page.js',
    };
    for (const link of document.querySelectorAll('.explore-nav a'))
        if (link.getAttribute('href') === page + '.html') link.setAttribute('aria-current', 'page');
    if (!files[page]) return;
    const P = explore.require('page.js');
    P.openTables();
    explore.page = explore.require(files[page])();
    // The scene goes along to the other pages.
    document.querySelector('.explore-nav').addEventListener('focusin', carry);
    document.querySelector('.explore-nav').addEventListener('pointerover', carry);
    function carry({ target }) {
        const href = target.getAttribute?.('href'),
            state = explore.page.get();
        if (!href || !('r' in state)) return;
        const scene = Object.fromEntries(P.sceneKeys.map((key) => [key, state[key]]));
        target.setAttribute(
            'href',
            href.replace(/#.*/, '') + (/^(machine|plane|integrators)/.test(href) ? P.hashOf(scene, P.sceneDefaults) : ''),
        );
    }
})();
