package org.maestro.sim.drivers;

import org.maestro.hal.Completion;
import org.maestro.hal.Loudspeaker;
import org.maestro.sim.parameters.SpeechData;
import org.maestro.sim.scene.WorldEvent;

/** A loudspeaker that is heard in its zone; it says one sentence after the other. */
final class SimulatedLoudspeaker implements Loudspeaker {

  private final Actuator actuator;
  private final SpeechData data;
  private final String zone;

  SimulatedLoudspeaker(Actuator actuator, SpeechData data, String zone) {
    this.actuator = actuator;
    this.data = data;
    this.zone = zone;
  }

  @Override
  public void say(String text, Completion completion) {
    actuator.command(
        WorldEvent.Kind.ADJUST,
        seconds(text),
        completion::failed,
        () -> {
          actuator.world().talk().sounds(actuator.device(), zone, text);
          completion.done();
        });
  }

  @Override
  public double seconds(String text) {
    return text.strip().split("\\s+").length * data.spokenWordSeconds();
  }
}
