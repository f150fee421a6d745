// Names that strangers chose, as they may stand among other words.

// Without what turns the text around them: Unicode's embeddings, overrides and isolates (UAX 9). Marks of right-to-left
// scripts stay, since names in these need them.
export function plainName(text: string): string {
  return text.replaceAll(/[\u202a-\u202e\u2066-\u2069]/g, "");
}

// As far as there is room for so many letters.
export function shortenedName(text: string, most: number): string {
  const letters = [...plainName(text)];
  return letters.length > most ? `${letters.slice(0, most - 1).join("")}…` : letters.join("");
}
