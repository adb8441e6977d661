// The axis of hours that all charts over time share.
import { axis, type Option } from './chart';
import type { Desk } from './desk';
import { time_ticks, type Reach } from './hours';

export function time_axis(desk: Desk, reach: Reach, width_px: number): Option {
  const every_h = width_px > 620 ? 6 : width_px > 330 ? 12 : 24;
  const ticks = time_ticks(reach, desk.look.zone, every_h);
  const at = ticks.map(({ at_ms }) => at_ms);
  return axis('', {
    type: 'value',
    min: reach.from_ms,
    max: reach.to_ms,
    axisTick: { show: true, customValues: at },
    axisLabel: {
      customValues: at,
      hideOverlap: true,
      alignMinLabel: 'left',
      alignMaxLabel: 'right',
      formatter: (at_ms: number) => ticks.find((tick) => tick.at_ms === at_ms)?.text ?? '',
    },
  });
}
