// Put before the theme's search worker by tools/docs-site, so that it gets each message first. Names such as `walk_to`,
// `no-ground`, `trigger.enter` or `library/door` are found as they are and by each of their parts; and `--strict` is a word,
// where lunr would take hyphens for the exclusion of what follows.
(() => {
  "use strict"; // here only: the theme's worker follows in this file
  const BETWEEN_WORDS = /[\s:,;()[\]{}"`]+/;
  const AROUND_WORDS = /^[-.]+|[-.]+$/g;

  /** A word, the pieces of a path, and their parts: each once. */
  const namesIn = (word) => {
    const pieces = word.split("/");
    return new Set([word, ...pieces, ...pieces.flatMap((piece) => piece.split(/[-._=]+/))]);
  };
  const namesOf = (text) => text.toLowerCase().split(BETWEEN_WORDS).map((word) => word.replace(AROUND_WORDS, ""))
    .flatMap((word) => [...namesIn(word)]).filter(Boolean);

  /** `no-ground` is looked for as it is, which lunr wants to be told and which counts most, and by its parts. */
  const wordOf = (typed) => {
    const word = typed.replace(AROUND_WORDS, "");
    return word.includes("-") ? `${word.replaceAll("-", "\\-")}^1000 ${word.replaceAll("-", " ")}` : word;
  };
  /** What was typed, without the signs that mean something else to lunr. */
  const queryOf = (typed) => typed.replace(/[`"'()[\]{}<>=,;:~^*|+\\]+/g, " ").split(/\s+/).map(wordOf).join(" ").trim();

  self.addEventListener("message", ({data: message}) => {
    if (message.type === 0) { // before the index is built
      const {lunr} = self;
      lunr.tokenizer = (field) => [field ?? ""].flat().flatMap((text) => namesOf(String(text)))
        .map((word, index) => new lunr.Token(word, {index}));
    } else if (message.type === 2) {
      message.data = queryOf(message.data);
    }
  });
})();
