// Numbers as people type them: with a decimal point, or with the comma that half of Europe has instead.

// Null where the text is no number. Of "1.000,5" nobody knows which mark is which: it is none.
export function parsedNumber(text: string): number | null {
  const plain = text.trim().replace(/^[−–]/, "-"); // a minus sign that was pasted
  return /^[-+]?(\d+([.,]\d*)?|[.,]\d+)(e[-+]?\d+)?$/i.test(plain) ? Number(plain.replace(",", ".")) : null;
}

// Such as a field begins with: no more figures than anyone has set.
export function numberText(value: number): string {
  return String(Number(value.toPrecision(6)));
}
