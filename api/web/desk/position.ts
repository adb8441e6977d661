export interface Place {
  longitude_deg: number;
  latitude_deg: number;
}
