// Small parts that panels are made of.
import type { ComponentChildren } from "preact";
import { useId, useState } from "preact/hooks";
import { Icon, type IconName } from "./icons";

interface ButtonProps {
  icon: IconName;
  label: string;
  onClick: () => void;
  disabled?: boolean;
  pressed?: boolean;
  kind?: string;
}

export function IconButton({ icon, label, onClick, disabled = false, pressed, kind = "" }: ButtonProps) {
  return (
    <button
      type="button"
      class={`icon-button ${kind}`}
      aria-label={label}
      title={label}
      aria-pressed={pressed}
      disabled={disabled}
      onClick={onClick}
    >
      <Icon name={icon} />
    </button>
  );
}

interface Choice<T extends string> {
  value: T;
  label: string;
  icon?: IconName;
}

interface SegmentedProps<T extends string> {
  legend: string;
  choices: readonly Choice<T>[];
  value: T;
  onChange: (value: T) => void;
}

// A choice of a few, as radio buttons styled as one control.
export function Segmented<T extends string>({ legend, choices, value, onChange }: SegmentedProps<T>) {
  const name = useId();
  return (
    <fieldset class="segmented">
      <legend>{legend}</legend>
      <div class="segments">
        {choices.map((choice) => (
          <label key={choice.value} title={choice.label}>
            <input type="radio" name={name} checked={choice.value === value} onChange={() => onChange(choice.value)} />
            <span>
              {choice.icon && <Icon name={choice.icon} />}
              <span class="segment-label">{choice.label}</span>
            </span>
          </label>
        ))}
      </div>
    </fieldset>
  );
}

interface NumberFieldProps {
  label: string;
  unit: string;
  value: number;
  min: number;
  max: number;
  step: number | "any";
  onInput: (value: number) => void;
  onDone: () => void;
}

// Input outside the range is not accepted: the field says what is, and has the last value again when it is left.
export function NumberField({ label, unit, value, min, max, step, onInput, onDone }: NumberFieldProps) {
  const id = useId();
  const [wrong, setWrong] = useState<string | null>(null); // what was typed instead
  const usual = String(Number(value.toPrecision(6)));
  return (
    <div class={`number-field ${wrong === null ? "" : "wrong"}`}>
      <label for={id}>{label}</label>
      <span class="number-box">
        <input
          id={id}
          type="number"
          inputMode="decimal"
          min={min}
          max={max}
          step={step}
          value={wrong ?? usual}
          aria-invalid={wrong !== null}
          aria-describedby={`${id}-unit ${id}-range`}
          onInput={(event) => {
            const { valueAsNumber: given, value: typed } = event.currentTarget;
            const fits = given >= min && given <= max;
            setWrong(fits ? null : typed);
            if (fits) onInput(given);
          }}
          onChange={onDone}
          onBlur={(event) => {
            if (wrong !== null) event.currentTarget.value = usual; // what is no number at all has no text to compare
            setWrong(null);
            onDone();
          }}
        />
        <span id={`${id}-unit`} class="unit">
          {unit}
        </span>
      </span>
      <span id={`${id}-range`} class="range-note" role="status">
        {wrong !== null && `From ${min} to ${max} ${unit}. Planned with ${usual}.`}
      </span>
    </div>
  );
}

export function Section({ title, children, kind = "" }: { title: string; children: ComponentChildren; kind?: string }) {
  const id = useId();
  return (
    <section class={`section ${kind}`} aria-labelledby={id}>
      <h2 id={id}>{title}</h2>
      {children}
    </section>
  );
}
