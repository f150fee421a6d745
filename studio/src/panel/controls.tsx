// Small parts that panels are made of.
import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";
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

export function Section({ title, children, kind = "" }: { title: string; children: ComponentChildren; kind?: string }) {
  const id = useId();
  return (
    <section class={`section ${kind}`} aria-labelledby={id}>
      <h2 id={id}>{title}</h2>
      {children}
    </section>
  );
}
