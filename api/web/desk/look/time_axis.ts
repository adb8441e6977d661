// The axis of hours that all charts over time share.
import { axis, type Option } from './chart';
import type { Desk } from './desk';
import { time_ticks, type Reach } from './hours';

export function time_axis(desk: Desk, reach: Reach, width_px: number): Option {
  const ticks = time_ticks(reach, desk.look.zone, width_px - 100);
  const at = ticks.map(({ at_ms }) => at_ms);
  return axis('', {
    type: 'value',
    min: reach.from_ms,
    max: reach.to_ms,
    axisTick: { show: true, customValues: at },
    axisLabel: {
      customValues: at,
      alignMinLabel: 'left',
      alignMaxLabel: 'right',
      formatter: (at_ms: number) => ticks.find((tick) => tick.at_ms === at_ms)?.text ?? '',
    },
  });
}
