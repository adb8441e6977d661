// @vitest-environment happy-dom
import { beforeEach, expect, test, vi } from 'vitest';
import { mapPart } from 'page/map/map';
import { coverage, late_server, site_answer, two_sites } from './late';

/** What of the box is asked for: the corner in the south-west tells the site. */
const KEPT = {
  '/collections/currents/cube?bbox=0.99800': coverage('b', 0.99),
  '/collections/wind/cube?bbox=0.99800': coverage('b', 9.9),
  '/collections/waves/cube?bbox=0.99800': coverage('b', 1.9),
  '/desk/land-50m.json': { objects: {} },
};

beforeEach(() => {
  // The picture has a size, which a page without a window cannot give.
  vi.stubGlobal(
    'ResizeObserver',
    class {
      constructor(private readonly call: () => void) {}
      observe(node: Element): void {
        Object.defineProperty(node, 'clientWidth', { value: 600 });
        Object.defineProperty(node, 'clientHeight', { value: 400 });
        this.call();
      }
    },
  );
});

test('TheLateFieldOfOneSiteIsNotDrawnAtAnother', async () => {
  const kept = { ...KEPT, '/sites/a': site_answer('a'), '/sites/b': site_answer('b') };
  const { desk, answer } = late_server(two_sites(), kept, { site: 'a' });
  const node = mapPart(desk);
  document.body.replaceChildren(node);
  await new Promise((over) => setTimeout(over, 20));
  desk.view.set({ site: 'b' });
  await new Promise((over) => setTimeout(over, 20));
  expect(node.querySelector('.water')?.textContent).toContain('0.99 m/s');
  await answer('cube?bbox=-2.552', coverage('a', 0.11));
  expect(node.querySelector('.water')?.textContent).toContain('0.99 m/s');
});

test('ASiteThatIsRefusedLeavesNothingOfTheOneBefore', async () => {
  const kept = { ...KEPT, '/sites/b': site_answer('b') };
  const { desk, answer } = late_server(two_sites(), kept, { site: 'b' });
  const node = mapPart(desk);
  document.body.replaceChildren(node);
  await new Promise((over) => setTimeout(over, 20));
  expect(node.querySelector('.picture')?.textContent).toContain('B01');
  desk.view.set({ site: 'a' });
  expect(node.querySelector('.picture')?.textContent).not.toContain('B01');
  expect(node.querySelector('.water')?.textContent).toBe('');
  await answer('/sites/a', { title: 'x', detail: 'the file is cut off' }, 500);
  expect(node.querySelector('.map-says')?.textContent).toContain('the file is cut off');
  expect(node.querySelector('.picture')?.textContent).not.toContain('B01');
});

test('ARefusalThatComesLateIsNotSaidOfAnotherSite', async () => {
  const kept = { ...KEPT, '/sites/b': site_answer('b') };
  const { desk, answer } = late_server(two_sites(), kept, { site: 'a' });
  const node = mapPart(desk);
  document.body.replaceChildren(node);
  await new Promise((over) => setTimeout(over, 5));
  desk.view.set({ site: 'b' });
  await answer('/sites/a', { title: 'x', detail: 'the file is cut off' }, 500);
  expect(node.querySelector('.map-says')?.textContent).toBe('');
});

const BED = {
  product: 'A_SURVEY',
  datum: 'geoid (mean sea level)',
  attribution: 'Who sounded it',
  features: [
    {
      properties: { depth_m: 20 },
      geometry: {
        coordinates: [
          [
            [0.9, 51],
            [1, 51.001],
            [1.1, 51],
          ],
        ],
      },
    },
  ],
};
const PORTS = [{ name: 'Emden', longitude_deg: 1.001, latitude_deg: 51.001 }];

test('ContoursLieBeneathAllElseAndSayWhoseTheyAre', async () => {
  const site = { ...(site_answer('b') as object), ports: PORTS };
  const kept = { ...KEPT, '/sites/b/bed': BED, '/sites/b': site };
  const { desk, answer } = late_server(two_sites(), kept, { site: 'b' });
  const node = mapPart(desk);
  document.body.replaceChildren(node);
  await new Promise((over) => setTimeout(over, 20));
  const picture = node.querySelector('.picture');
  expect(picture?.firstElementChild?.getAttribute('class')).toBe('bed');
  expect(picture?.querySelectorAll('.contour').length).toBe(1);
  expect(picture?.querySelector('.contour')?.textContent).toBe('20 m below geoid (mean sea level)');
  expect(picture?.querySelector('.depth')?.textContent).toBe('20 m');
  expect(picture?.textContent).toContain('Emden');
  const legend = node.querySelector('.legend');
  expect(legend?.textContent).toContain('Depths: A_SURVEY, Who sounded it');
  const box = legend?.querySelectorAll('input')[3] as HTMLInputElement;
  box.checked = false;
  box.dispatchEvent(new Event('change'));
  expect(picture?.querySelectorAll('.contour').length).toBe(0);
  // Of a site without there is nothing of the one before, and it says why.
  box.checked = true;
  desk.view.set({ site: 'a' });
  await answer('/sites/a', site_answer('a'));
  await answer('/sites/a/bed', { title: 'x', detail: 'found no bathymetry' }, 404);
  expect(picture?.querySelectorAll('.contour').length).toBe(0);
  expect(legend?.textContent).toContain('No depth contours: found no bathymetry');
  expect(picture?.textContent).not.toContain('Emden');
});
