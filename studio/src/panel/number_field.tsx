// A number to type, with its unit. It is no number field of the browser's: those drop a comma without a word, so that 1,5
// becomes 15, or forget what was typed.
import { useId, useState } from "preact/hooks";
import { numberText, parsedNumber } from "../domain/number_text";

interface NumberFieldProps {
  label: string;
  unit: string;
  value: number | null; // null: any
  min: number;
  max: number;
  onInput: (value: number) => void;
  onClear?: () => void; // where it may be left empty
  empty?: string; // what that stands for
  onDone?: () => void;
}

interface Typed {
  text: string;
  of: number | null; // the value that it stands for, or stands in the way of
}

// What cannot be taken stands, with what is said of it, until it is mended or the value changes otherwise.
export function NumberField(props: NumberFieldProps) {
  const { label, unit, value, min, max, onInput, onClear, empty = "any", onDone = () => undefined } = props;
  const id = useId();
  const [typed, setTyped] = useState<Typed | null>(null);
  const taken = (text: string): number | null => {
    const number = parsedNumber(text);
    return number !== null && number >= min && number <= max ? number : null;
  };
  const isCleared = (text: string) => onClear !== undefined && text.trim() === "";
  const textOf = (number: number | null) => (number === null ? "" : numberText(number));
  const usual = textOf(value);
  const text = typed !== null && textOf(typed.of) === usual ? typed.text : usual;
  const isWrong = text !== usual && !isCleared(text) && taken(text) === null;
  const orNothing = onClear ? ", or nothing" : "";
  return (
    <div class={`number-field ${isWrong ? "wrong" : ""}`}>
      <label for={id}>{label}</label>
      <span class="number-box">
        <input
          id={id}
          type="text"
          inputMode={min < 0 ? "text" : "decimal"} // a phone's keys for decimals have no minus
          autocomplete="off"
          value={text}
          placeholder={onClear && empty}
          aria-invalid={isWrong}
          aria-describedby={`${id}-unit ${id}-range`}
          onInput={(event) => {
            const { value: now } = event.currentTarget;
            const number = taken(now);
            setTyped({ text: now, of: isCleared(now) ? null : (number ?? value) });
            if (isCleared(now)) onClear!();
            else if (number !== null) onInput(number);
          }}
          onBlur={() => {
            if (!isWrong) setTyped(null);
            onDone();
          }}
          onChange={onDone}
        />
        <span id={`${id}-unit`} class="unit">
          {unit}
        </span>
      </span>
      <span id={`${id}-range`} class="range-note" role="status">
        {isWrong && `Give ${min} to ${max} ${unit}${orNothing}. Until then it stays ${usual || empty}.`}
      </span>
    </div>
  );
}
