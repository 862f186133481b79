package org.maestro.console.traffic;

import com.fasterxml.jackson.databind.JsonNode;

/** News under numbers that grow, for whoever listens. Any thread may ask. */
public interface Source {
  /** The number of the latest news; 0 before there is any. */
  long latest();

  /** What came after one number and not after the other; from 0 on it is all that is kept. */
  JsonNode between(long after, long last);

  /** All that is kept. */
  default JsonNode all() {
    return between(0, latest());
  }
}
