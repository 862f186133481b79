package org.maestro.device.tasks;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.hal.Camera;
import org.maestro.rats.protocol.RatsError;
import org.maestro.sl.Term;

/**
 * The verdict that a burst of frames allows.
 *
 * @param found enough frames agree
 * @param unfit areas in which the light does not allow to say "not there", or, where a part is
 *     over-lit, anything; empty: it is not there
 */
record SightVerdict(boolean found, List<UnfitLight> unfit) {

  /** A detection in one or two frames may be noise. Stated assumption. */
  static final int AGREEING_FRAMES = 3;

  /** The greatest chance of missing what is there that still allows to say "not there". */
  static final double MISS_LIMIT = 1e-6;

  /**
   * Light that stands in the way.
   *
   * @param need reads {@code >= 72}
   * @param glare a part of the area is over-lit, whatever the light at its reference point is
   */
  record UnfitLight(String area, double lux, String need, boolean glare) {}

  SightVerdict {
    unfit = List.copyOf(unfit);
  }

  static SightVerdict of(Camera.Look look, Camera camera) {
    if (!look.glaring().isEmpty()) {
      return new SightVerdict(
          false,
          look.glaring().stream()
              .map(light -> unfit(light, light.brightestLux(), "<= ", camera.maximumLux(), true))
              .toList());
    }
    if (look.detections() >= AGREEING_FRAMES && look.position().isPresent()) {
      return new SightVerdict(true, List.of());
    }
    List<UnfitLight> unfit = new ArrayList<>();
    for (Camera.AreaLight light : look.areas()) {
      boolean missed = false;
      for (double lux : new double[] {light.darkestLux(), light.brightestLux()}) {
        missed |= missProbability(look.frames(), camera.detectability(lux)) >= MISS_LIMIT;
      }
      double minimum = camera.minimumLux();
      double maximum = camera.maximumLux();
      if (light.referenceLux() < minimum) {
        unfit.add(unfit(light, light.referenceLux(), ">= ", minimum, false));
      } else if (light.referenceLux() > maximum) {
        unfit.add(unfit(light, light.referenceLux(), "<= ", maximum, false));
      } else if (missed && light.darkestLux() < minimum) {
        unfit.add(unfit(light, light.darkestLux(), ">= ", minimum, false));
      } else if (missed) {
        unfit.add(unfit(light, light.brightestLux(), "<= ", maximum, true));
      }
    }
    return new SightVerdict(false, unfit);
  }

  /**
   * The chance that fewer frames than must agree show what is there, one frame showing it with the
   * given chance.
   */
  static double missProbability(int frames, double detectability) {
    double tail = 0;
    double ways = 1;
    for (int shown = 0; shown < AGREEING_FRAMES; shown++) {
      tail += ways * Math.pow(detectability, shown) * Math.pow(1 - detectability, frames - shown);
      ways = ways * (frames - shown) / (shown + 1);
    }
    return tail;
  }

  /** Says why a look came to nothing. */
  static RatsError doubt(String reason) {
    return FeatureContext.unmet(reason, "have another camera look, or look later", List.of());
  }

  /** Says which light stands in the way. */
  RatsError refusal(FeatureContext context, CallParameters parameters, Camera camera) {
    List<RatsError.Reference> references = new ArrayList<>();
    List<String> lights = new ArrayList<>();
    for (UnfitLight light : unfit) {
      Map<String, Term> area = new TreeMap<>(Map.of("zone", new Term.Name(light.area())));
      Optional<RatsError.Reference> glare =
          light.glare()
              ? context.reference("glare", parameters, area, "false", true)
              : Optional.empty();
      glare
          .or(() -> context.reference("light", parameters, area, light.need(), light.lux()))
          .ifPresent(references::add);
      lights.add(
          "%s lux in %s, %s needed"
              .formatted(Numbers.plain(light.lux()), light.area(), light.need()));
    }
    boolean dark = unfit.stream().anyMatch(light -> light.lux() < camera.minimumLux());
    return FeatureContext.unmet(
        String.join("; ", lights), dark ? "raise the light" : "lower the light", references);
  }

  private static UnfitLight unfit(
      Camera.AreaLight light, double lux, String relation, double limit, boolean glare) {
    return new UnfitLight(
        light.area(), Numbers.tenths(lux), relation + Numbers.plain(limit), glare);
  }
}
