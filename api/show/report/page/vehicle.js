'use strict';
// Draws the plots of `vehicle check --html`.
(() => {
  const {data, theme, dashOf, fixed, valueAxis, chartOf, drawn, start} = slackwaterPage;
  const margins = {left: 70, right: 20, top: 44, bottom: 50};

  /** Ranges about the points, a metre as long along both axes of this chart. */
  const evenRange = (chart, points) => {
    const low = [0, 1].map((k) => Math.min(...points.map((p) => p[k])));
    const high = [0, 1].map((k) => Math.max(...points.map((p) => p[k])));
    const wide = Math.max(50, chart.getWidth() - margins.left - margins.right);
    const tall = Math.max(50, chart.getHeight() - margins.top - margins.bottom);
    const metresPerPixel = 1.1 * Math.max((high[0] - low[0]) / wide, (high[1] - low[1]) / tall, 1e-6);
    return [wide, tall].map((pixels, k) => [(low[k] + high[k] - pixels * metresPerPixel) / 2, (low[k] + high[k] + pixels * metresPerPixel) / 2]);
  };
  const plain = {formatter: (v) => (+v.toFixed(2)).toString(), showMinLabel: false, showMaxLabel: false};

  const circleOption = (t, chart) => {
    const [across, along] = evenRange(chart, data.circle);
    const axis = (name, [min, max], extra) => {
      const made = valueAxis(t, name, {min, max, ...extra});
      return {...made, axisLabel: {...made.axisLabel, ...plain}};
    };
    return {
      animation: false, grid: margins,
      tooltip: {trigger: 'item', formatter: (x) => `across ${fixed(x.value[0], 1)} m, along ${fixed(x.value[1], 1)} m`},
      xAxis: axis('across (m)', across, {nameGap: 30}),
      yAxis: axis('along (m)', along),
      series: [{name: 'turning circle', type: 'line', showSymbol: true, symbol: 'circle', symbolSize: (_, p) => (p.dataIndex === 0 ? 12 : 0), data: data.circle,
        itemStyle: {color: t.paper, borderColor: t.of(0), borderWidth: 2}, lineStyle: {color: t.of(0), width: 2}}],
    };
  };
  const zigzagOption = (t) => ({
    animation: false, grid: margins,
    legend: {top: 0, textStyle: {color: t.ink}, data: data.zigzags.map((z) => z.name)},
    tooltip: {trigger: 'axis', formatter: (items) => [`${fixed(items[0].value[0], 1)} s`, ...items.map((x) => `${x.marker}${echarts.format.encodeHTML(x.seriesName)} <b>${fixed(x.value[1], 1)}°</b>`)].join('<br>')},
    xAxis: valueAxis(t, 'since the first helm (s)', {nameGap: 30}),
    yAxis: valueAxis(t, 'heading (°)'),
    series: data.zigzags.map((z, j) => ({name: z.name, type: 'line', showSymbol: false, data: z.heading, itemStyle: {color: t.of(j)}, lineStyle: {color: t.of(j), width: 2, type: dashOf(j)}})),
  });

  const circle = data.circle.length ? chartOf('circle') : null;
  const drawCircle = () => circle.draw(circleOption(theme(), circle));
  if (circle) drawn.push(drawCircle);
  const zigzag = data.zigzags.length ? chartOf('zigzag') : null;
  if (zigzag) drawn.push(() => zigzag.draw(zigzagOption(theme())));
  start();
  // After the chart has its new size: another shape shows another range.
  if (circle) window.addEventListener('resize', drawCircle);
})();
