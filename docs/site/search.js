// The search page: looks the words of ?q= up in the site's own list of pages, search-documents.js, with lunr.
(function () {
  "use strict";
  const words = (new URLSearchParams(location.search).get("q") || "").trim();
  const place = document.getElementById("search-results");
  if (!words || !place) return;
  document.getElementById("site-search").value = words;

  const documents = window.searchDocuments; // {title, url, text}, an entry a page or a documented name
  const index = lunr(function () {
    this.ref("place");
    this.field("title", {boost: 8});
    this.field("text");
    this.pipeline.remove(lunr.stopWordFilter);
    this.searchPipeline.remove(lunr.stemmer);
    this.pipeline.remove(lunr.stemmer);
    documents.forEach((each, at) => {
      const boost = each.url.includes("#") ? 3 : /Reference$/.test(each.title) ? 1 : 6; // names, lists of names, texts
      this.add({place: at, title: each.title.replace(/_/g, " ") + " " + each.title, text: each.text}, {boost});
    });
  });

  // An equation is found by its number alone, with or without parentheses.
  const number = /^\(?(A\.)?(\d+)\)?$/i.exec(words);
  const found = [];
  if (number) {
    const wanted = "(" + (number[1] ? "A." : "") + number[2] + ")";
    documents.forEach((each, at) => { if (each.title.startsWith("Equation " + wanted)) found.push(at); });
  }
  const terms = words.toLowerCase().split(/[\s(){}:,;]+/).filter(Boolean);
  index.query(function (query) {
    terms.forEach((term) => {
      query.term(term, {boost: 10});
      query.term(term, {wildcard: lunr.Query.wildcard.TRAILING});
    });
  }).forEach((each) => { if (!found.includes(+each.ref)) found.push(+each.ref); });

  place.textContent = "";
  const said = document.createElement("p");
  said.textContent = found.length === 0 ? "Nothing is found for " + words + "."
                                        : found.length + (found.length === 1 ? " page" : " pages") + " for " + words + ":";
  place.appendChild(said);
  const list = document.createElement("ol");
  list.className = "results";
  found.slice(0, 60).forEach((at) => {
    const item = document.createElement("li"), link = document.createElement("a"), text = document.createElement("p");
    link.href = documents[at].url;
    link.textContent = documents[at].title;
    text.textContent = documents[at].text.slice(0, 160);
    item.append(link, text);
    list.appendChild(item);
  });
  place.appendChild(list);
})();
