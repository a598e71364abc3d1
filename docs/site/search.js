// The search page: looks the words of ?q= up in the site's own list of pages, search-documents.js, with lunr.
(function () {
  "use strict";
  const words = (new URLSearchParams(location.search).get("q") || "").trim();
  const place = document.getElementById("search-results");
  if (!words || !place) return;
  document.getElementById("site-search").value = words;

  const documents = window.searchDocuments; // {title, url, text, kind}, an entry a page or a documented name
  const weight = [8, 6, 5, 2, 1]; // by kind: equations, figures and the derivation, other texts, what is behind an equation, code
  const index = lunr(function () {
    this.ref("place");
    this.field("title", {boost: 8});
    this.field("text");
    this.pipeline.remove(lunr.stopWordFilter);
    this.searchPipeline.remove(lunr.stemmer);
    this.pipeline.remove(lunr.stemmer);
    documents.forEach((each, at) => {
      this.add({place: at, title: each.title.replace(/_/g, " ") + " " + each.title, text: each.text}, {boost: weight[each.kind]});
    });
  });

  // The index parts words at hyphens, and so must the question.
  const terms = words.toLowerCase().split(/[\s(){}:,;.\-\u2010-\u2014]+/).filter(Boolean);
  const whole = terms.join(" ");
  const found = index.query(function (query) {
    terms.forEach((term) => {
      query.term(term, {boost: 10});
      if (term.length > 2) query.term(term, {wildcard: lunr.Query.wildcard.TRAILING});
    });
  }).map((each) => {
    const page = documents[+each.ref], text = (page.title + " " + page.text).toLowerCase().replace(/[-_]/g, " ");
    const all = terms.filter((term) => text.includes(term)).length / terms.length;
    const named = page.title.replace(/^(Equation \(.*?\)):.*/, "$1").toLowerCase().replace(/[-_()]/g, " ").trim() === whole;
    return {page, score: each.score * weight[page.kind] * all * all * (text.includes(whole) ? 2 : 1) + (named && (page.kind < 4 || /[_(:]/.test(words)) ? 1e6 : 0)};
  }).sort((a, b) => b.score - a.score);

  // The text around the first of the words.
  function excerpt(text) {
    const places = terms.map((term) => text.toLowerCase().indexOf(term)).filter((at) => at >= 0);
    const at = places.length ? Math.max(0, Math.min(...places) - 60) : 0;
    const from = at === 0 ? 0 : text.indexOf(" ", at) + 1;
    return (from > 0 ? "… " : "") + text.slice(from, from + 180) + (from + 180 < text.length ? " …" : "");
  }

  place.textContent = "";
  const said = document.createElement("p");
  said.textContent = found.length === 0 ? "No page was found for " + words + ". Try fewer words, or the number of an equation."
                                        : found.length + (found.length === 1 ? " page" : " pages") + " for " + words + ":";
  place.appendChild(said);
  const list = document.createElement("ol");
  list.className = "results";
  found.slice(0, 40).forEach(({page}) => {
    const item = document.createElement("li"), link = document.createElement("a"), text = document.createElement("p");
    link.href = page.url;
    link.textContent = page.title;
    text.textContent = excerpt(page.text);
    item.append(link, text);
    list.appendChild(item);
  });
  place.appendChild(list);
})();
