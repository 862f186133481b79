package org.maestro.knowledge.calibration;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.maestro.knowledge.api.Snapshot;

/**
 * A number as one observer measures it, and what is learnt of the shares in it. Confined to one
 * thread.
 */
final class MeasuredNumber {
  /** A measurement that comes sooner after a setting may have been made before it. */
  private static final Duration SETTLED = Duration.ofMillis(400);

  /** What was learnt longer ago is tried anew: lamps are cleaned, and bulbs replaced. */
  private static final Duration REMEMBERED = Duration.ofDays(1);

  /** After such a time anything may have happened to the rest. */
  private static final Duration LONG = Duration.ofMinutes(10);

  /** The least difference, of what is stated, from what was told last. */
  private static final double NEWS = 0.05;

  private final List<Part> parts;
  private final ShareFilter filter;
  private final double[] settings;
  private final boolean[] known;
  private final Instant[] learnt;
  private final Map<Part, Double> told = new LinkedHashMap<>();
  private Instant last = Instant.MIN;

  /**
   * @param parts none: then nothing is learnt of it
   */
  MeasuredNumber(List<Part> parts) {
    this.parts = List.copyOf(parts);
    this.filter = new ShareFilter(parts.stream().mapToDouble(Part::stated).toArray());
    this.settings = new double[parts.size()];
    this.known = new boolean[parts.size()];
    this.learnt = new Instant[parts.size()];
    Arrays.fill(learnt, Instant.MIN);
  }

  /** Something that has no share has changed the number. */
  void disturbed() {
    filter.forgetRest();
  }

  /** Takes a measurement, unless a setting is as new as it. */
  void measured(double number, Snapshot now) {
    if (parts.isEmpty() || isUnsettled(now)) {
      return;
    }
    boolean isLong = last.isBefore(now.at().minus(LONG));
    double[] current = new double[settings.length];
    boolean areTheSameKnown = true;
    for (int part = 0; part < current.length; part++) {
      OptionalDouble setting = now.number(parts.get(part).setting());
      areTheSameKnown &= known[part] == setting.isPresent();
      known[part] = setting.isPresent();
      // What nobody knows counts as a part of the rest.
      current[part] = setting.orElse(0);
      if (!isLong && current[part] != settings[part]) {
        learnt[part] = now.at();
      }
    }
    if (isLong || !areTheSameKnown) {
      filter.forgetRest();
    }
    forgetWhatIsOld(now.at());
    double seconds = isLong ? 0 : Duration.between(last, now.at()).toMillis() / 1e3;
    filter.measured(seconds, current, number);
    System.arraycopy(current, 0, settings, 0, current.length);
    last = now.at();
  }

  private boolean isUnsettled(Snapshot now) {
    Instant settled = now.at().minus(SETTLED);
    return parts.stream()
        .flatMap(part -> now.belief(part.setting()).stream())
        .anyMatch(belief -> belief.since().isAfter(settled));
  }

  private void forgetWhatIsOld(Instant now) {
    for (int part = 0; part < learnt.length; part++) {
      if (!learnt[part].equals(Instant.MIN) && learnt[part].plus(REMEMBERED).isBefore(now)) {
        filter.restart(part);
        learnt[part] = Instant.MIN;
      }
    }
  }

  /** The parts that are otherwise than stated, as they are. */
  Map<Part, Double> otherwise() {
    for (int n = 0; n < parts.size(); n++) {
      Part part = parts.get(n);
      double share = filter.share(n);
      if (told.containsKey(part) ? !filter.isAsStated(n) : filter.isOtherwise(n)) {
        told.merge(part, share, (before, now) -> isNews(part, before, now) ? now : before);
      } else {
        told.remove(part);
      }
    }
    return told;
  }

  /** Small differences are not told, so that nobody plans anew for them. */
  private static boolean isNews(Part part, double before, double now) {
    return Math.abs(now - before) >= NEWS * Math.abs(part.stated());
  }
}
