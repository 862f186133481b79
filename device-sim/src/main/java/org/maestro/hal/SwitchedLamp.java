package org.maestro.hal;

import java.util.List;
import java.util.OptionalInt;

/** A lamp behind a switch: dark or at full level, with the one white that it has. */
public final class SwitchedLamp implements DimmableLamp {

  private final Switch relay;
  private final int whiteKelvin;

  public SwitchedLamp(Switch relay, int whiteKelvin) {
    this.relay = relay;
    this.whiteKelvin = whiteKelvin;
  }

  @Override
  public void set(double level, OptionalInt white, Completion completion) {
    if (level != 0 && level != 1) {
      completion.failed("it can be switched on and off only, not dimmed to " + level);
    } else if (white.isPresent() && white.getAsInt() != whiteKelvin) {
      completion.failed("it has no white of %d K".formatted(white.getAsInt()));
    } else {
      relay.set(level == 1, completion);
    }
  }

  @Override
  public double level() {
    return relay.isOn() ? 1 : 0;
  }

  @Override
  public int whiteKelvin() {
    return whiteKelvin;
  }

  @Override
  public List<Integer> whites() {
    return List.of(whiteKelvin);
  }
}
