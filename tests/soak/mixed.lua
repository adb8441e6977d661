-- wrk: mixed queries of every format in turn; the site is the SITE line of the environment, "LONGITUDE LATITUDE".
local place = os.getenv("SLACKWATER_SOAK_PLACE")
local instance = os.getenv("SLACKWATER_SOAK_INSTANCE")
local point = "coords=POINT(" .. place:gsub(" ", "%%20") .. ")"
local currents = "/collections/currents"
local targets = {
  currents .. "/position?" .. point .. "&z=R50/0/0.5&datetime=" .. os.getenv("SLACKWATER_SOAK_TIME"),
  currents .. "/position?" .. point .. "&z=5",
  currents .. "/position?" .. point .. "&z=0/30&parameter-name=sea_water_speed&f=CSV",
  currents .. "/position?" .. point .. "&z=5&f=GeoJSON",
  currents .. "/instances/" .. instance .. "/position?" .. point .. "&z=5",
  "/collections/currents-members/position?" .. point .. "&z=5",
  "/collections/wind/position?" .. point .. "&z=100",
  "/collections/waves/position?" .. point,
  currents .. "/radius?" .. point .. "&within=2&within-units=km&z=5&resolution-x=20&resolution-y=20",
  currents .. "/position?" .. point .. "&z=5&f=NetCDF",
  currents .. "/position?coords=POINT(181)",
  currents .. "/position?coords=POINT(0%200)",
  "/collections", "/health", "/metrics", "/no/such/path",
}
local n = 0
function request()
  n = n + 1
  return wrk.format("GET", targets[n % #targets + 1])
end
