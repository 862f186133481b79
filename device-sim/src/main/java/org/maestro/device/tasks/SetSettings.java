package org.maestro.device.tasks;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.hal.Settings;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.rats.member.Execution;
import org.maestro.sl.Term;

/** Sets an appliance: each input of the feature is the setting of its name. */
final class SetSettings extends DeviceProcedure {

  private final Settings appliance;

  /**
   * @throws DeviceSetupException when an input is no setting of the device
   */
  SetSettings(FeatureContext context) {
    this.appliance = context.driver(Settings.class);
    context.feature().inputs().stream()
        .map(Parameter::name)
        .filter(input -> !appliance.names().contains(input))
        .findFirst()
        .ifPresent(
            input -> {
              throw new DeviceSetupException(
                  "The device %s offers %s, whose input %s is no setting of it; it has %s. Say maestro:setting of the device or its class, or take the feature away."
                      .formatted(
                          context.device(),
                          context.feature().name(),
                          input,
                          appliance.names().isEmpty()
                              ? "none"
                              : String.join(", ", appliance.names())));
            });
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    appliance.set(wanted(parameters), ending(execution), execution::ended);
  }

  @Override
  Estimate cost(CallParameters parameters) {
    Map<String, Term> wanted = wanted(parameters);
    Map<String, Term> now = appliance.values();
    return now.entrySet().containsAll(wanted.entrySet())
        ? price(0, 0)
        : price(appliance.seconds(wanted.keySet()), 0);
  }

  private Map<String, Term> wanted(CallParameters parameters) {
    Map<String, Term> wanted = new TreeMap<>(parameters.terms());
    wanted.keySet().retainAll(appliance.names());
    Optional<String> refusal = appliance.refusal(wanted);
    if (refusal.isPresent()) {
      throw new InvalidCallException(refusal.get());
    }
    return wanted;
  }
}
