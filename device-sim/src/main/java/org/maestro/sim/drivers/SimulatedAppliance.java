package org.maestro.sim.drivers;

import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import java.util.function.UnaryOperator;
import org.maestro.hal.Completion;
import org.maestro.hal.Settings;
import org.maestro.hal.Switch;
import org.maestro.ontology.home.Setting;
import org.maestro.sim.parameters.DriveData;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sl.Term;

/**
 * An appliance whose settings are data, such as a television, a stereo, an oven or a thermostat: it
 * keeps what it is set to, and tells it.
 */
final class SimulatedAppliance implements Switch, Settings {

  private final Actuator actuator;
  private final DriveData data;
  private final Map<String, Setting> settings;
  private State state;
  private State ordered;

  private record State(boolean on, Map<String, Term> values) {}

  /**
   * @param on whether it is on at first
   * @param values how it is set at first, where that is not as its settings say
   */
  SimulatedAppliance(
      Actuator actuator,
      DriveData data,
      Map<String, Setting> settings,
      boolean on,
      Map<String, Term> values) {
    this.actuator = actuator;
    this.data = data;
    this.settings = settings;
    Map<String, Term> all = usual(on, Map.of());
    all.putAll(values);
    this.state = new State(on, all);
    this.ordered = state;
  }

  /** As everything is of its own accord, over what is kept. */
  private Map<String, Term> usual(boolean on, Map<String, Term> kept) {
    Map<String, Term> values = new TreeMap<>();
    settings.forEach(
        (name, setting) -> {
          if (on || !setting.whileOn()) {
            setting.atFirst().ifPresent(value -> values.put(name, value));
            Optional.ofNullable(kept.get(name)).ifPresent(value -> values.put(name, value));
          }
        });
    return values;
  }

  @Override
  public void set(boolean on, Completion completion) {
    if (on == isOn()) {
      completion.done();
    } else {
      become(0, before -> new State(on, usual(on, before.values())), completion, () -> false);
    }
  }

  @Override
  public void set(Map<String, Term> values, Completion completion, BooleanSupplier isCalledOff) {
    if (!isOn() && values.keySet().stream().anyMatch(name -> setting(name).whileOn())) {
      completion.failed("it is switched off");
    } else {
      become(seconds(values.keySet()), before -> with(before, values), completion, isCalledOff);
    }
  }

  private static State with(State before, Map<String, Term> values) {
    Map<String, Term> all = new TreeMap<>(before.values());
    all.putAll(values);
    return new State(before.on(), all);
  }

  private void become(
      double seconds,
      UnaryOperator<State> next,
      Completion completion,
      BooleanSupplier isCalledOff) {
    actuator.command(
        WorldEvent.Kind.ADJUST,
        data.relaySeconds() + seconds,
        completion::failed,
        () -> {
          if (isCalledOff.getAsBoolean()) {
            return;
          }
          ordered = next.apply(told());
          if (!actuator.flaw().isIdle()) {
            state = next.apply(state);
          }
          actuator.tell(WorldEvent.Kind.SWITCHED);
          completion.done();
        });
  }

  private State told() {
    return actuator.flaw().repeatsOrders() ? ordered : state;
  }

  @Override
  public boolean isOn() {
    return told().on();
  }

  @Override
  public Map<String, Term> values() {
    return told().values();
  }

  /** What a setting truly is, whatever is told of it; empty when it is no number now. */
  OptionalDouble number(String name) {
    return state.values().get(name) instanceof Term.Number number
        ? OptionalDouble.of(number.value())
        : OptionalDouble.empty();
  }

  @Override
  public Set<String> names() {
    return settings.keySet();
  }

  private Setting setting(String name) {
    return Objects.requireNonNull(settings.get(name), name);
  }

  @Override
  public Optional<String> refusal(Map<String, Term> values) {
    return values.entrySet().stream()
        .flatMap(
            entry ->
                setting(entry.getKey()).refusal(entry.getValue()).stream()
                    .map(reason -> "The " + entry.getKey() + " " + reason + "."))
        .findFirst();
  }

  @Override
  public double seconds(Set<String> names) {
    return names.stream().mapToDouble(name -> setting(name).delaySeconds()).max().orElse(0);
  }
}
