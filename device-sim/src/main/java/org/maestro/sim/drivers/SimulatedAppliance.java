package org.maestro.sim.drivers;

import java.util.Optional;
import org.maestro.hal.Completion;
import org.maestro.hal.Selector;
import org.maestro.hal.Switch;
import org.maestro.sim.parameters.DriveData;
import org.maestro.sim.scene.WorldEvent;

/**
 * An appliance such as a television: off at first, and what is chosen at it is so while it is on.
 */
final class SimulatedAppliance implements Switch, Selector {

  private final Actuator actuator;
  private final DriveData data;
  private State state = State.OFF;
  private State ordered = State.OFF;

  private record State(boolean on, Optional<String> selected) {
    static final State OFF = new State(false, Optional.empty());
    static final State ON = new State(true, Optional.empty());
  }

  SimulatedAppliance(Actuator actuator, DriveData data) {
    this.actuator = actuator;
    this.data = data;
  }

  @Override
  public void set(boolean on, Completion completion) {
    if (on == isOn()) {
      completion.done();
    } else {
      become(on ? State.ON : State.OFF, completion);
    }
  }

  @Override
  public void select(String choice, Completion completion) {
    if (isOn()) {
      become(new State(true, Optional.of(choice)), completion);
    } else {
      completion.failed("it is switched off");
    }
  }

  private void become(State next, Completion completion) {
    actuator.command(
        WorldEvent.Kind.ADJUST,
        data.relaySeconds(),
        completion::failed,
        () -> {
          ordered = next;
          if (!actuator.flaw().isIdle()) {
            state = next;
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
  public Optional<String> selected() {
    return told().selected();
  }
}
