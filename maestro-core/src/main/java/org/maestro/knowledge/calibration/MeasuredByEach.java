package org.maestro.knowledge.calibration;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.maestro.knowledge.api.Snapshot;

/**
 * A number as each observer measures it: a camera tells of the light where it looks, and a sensor
 * of that where it stands. What counts is what was learnt of the one who measured last, as plans
 * start from his number. Confined to one thread.
 */
final class MeasuredByEach {
  private final List<Part> parts;
  private final Map<String, MeasuredNumber> byObserver = new LinkedHashMap<>();
  private MeasuredNumber latest;

  MeasuredByEach(List<Part> parts) {
    this.parts = List.copyOf(parts);
    this.latest = new MeasuredNumber(this.parts);
  }

  List<Part> parts() {
    return parts;
  }

  void measured(String observer, double number, Snapshot now) {
    latest = byObserver.computeIfAbsent(observer, name -> new MeasuredNumber(parts));
    latest.measured(number, now);
  }

  /** Something that has no share has changed the number. */
  void disturbed() {
    byObserver.values().forEach(MeasuredNumber::disturbed);
  }

  /** The parts that are otherwise than stated, as they are. */
  Map<Part, Double> otherwise() {
    return latest.otherwise();
  }
}
