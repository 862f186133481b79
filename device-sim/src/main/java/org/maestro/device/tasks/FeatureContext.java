package org.maestro.device.tasks;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.hal.Drivers;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Term;

/**
 * The means of a procedure: its feature's description, the device's drivers and the clock.
 *
 * @param deposits the device's memory, shared by its features
 * @param motion of the device's base, shared by them, too
 */
public record FeatureContext(
    String device,
    FeatureType feature,
    Drivers drivers,
    Clock clock,
    FactTemplates quantities,
    Deposits deposits,
    Motion motion) {

  public static FeatureContext of(
      String device,
      FeatureType feature,
      Drivers drivers,
      Clock clock,
      Deposits deposits,
      Motion motion) {
    return new FeatureContext(
        device,
        feature,
        drivers,
        clock,
        new FactTemplates(device, feature.refersTo()),
        deposits,
        motion);
  }

  /**
   * @throws DeviceSetupException when the device has no such driver
   */
  <T> T driver(Class<T> kind) {
    return drivers
        .find(kind)
        .orElseThrow(
            () ->
                new DeviceSetupException(
                    "The device "
                        + device
                        + " offers "
                        + feature.name()
                        + ", but its driver is no "
                        + kind.getSimpleName()
                        + ". Give it another driver, or take the feature away."));
  }

  /** The fact that stands in the way, if the description says what the quantity means. */
  Optional<RatsError.Reference> reference(
      String quantity,
      CallParameters parameters,
      Map<String, Term> also,
      String need,
      Object have) {
    Map<String, Term> values = new TreeMap<>(parameters.terms());
    values.putAll(also);
    return quantities.fact(quantity, values).map(fact -> new RatsError.Reference(fact, need, have));
  }

  static RatsError unmet(String message, String hint, List<RatsError.Reference> references) {
    return new RatsError(
        ErrorCode.PRECONDITION_NOT_MET,
        RatsError.Level.WARNING,
        message,
        Optional.of(hint),
        references,
        true);
  }

  static RatsError broken(String message) {
    return new RatsError(
        ErrorCode.HARDWARE_FAILURE,
        RatsError.Level.ERROR,
        message,
        Optional.empty(),
        List.of(),
        false);
  }

  static RatsError invalid(String message) {
    return new RatsError(
        ErrorCode.INVALID_PARAMETERS,
        RatsError.Level.ERROR,
        message,
        Optional.empty(),
        List.of(),
        false);
  }
}
