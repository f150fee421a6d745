// How wide a vehicle is: one of a few sizes.
import { useId } from "preact/hooks";
import { length, type Units } from "../domain/units";

const usualRadii = [0, 0.5, 1, 1.5, 2, 3, 4];

interface Props {
  label: string;
  radius: number;
  units: Units;
  onChange: (radius: number) => void;
}

export function VehicleSize({ label, radius, units, onChange }: Props) {
  const id = useId();
  const radii = usualRadii.includes(radius) ? usualRadii : [...usualRadii, radius].sort((a, b) => a - b);
  const wide = (r: number) =>
    units.metric ? `${Number((2 * r * units.cell).toPrecision(3))} m` : length(2 * r, units);
  return (
    <div class="number-field">
      <label for={id}>{label}</label>
      <select id={id} value={String(radius)} onChange={(event) => onChange(Number(event.currentTarget.value))}>
        {radii.map((r) => (
          <option key={r} value={String(r)}>
            {r === 0 ? "a point" : wide(r)}
          </option>
        ))}
      </select>
    </div>
  );
}
