package org.maestro.launch;

import org.maestro.hal.wheels.Stance;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;

/** What commands that present hardware as a home's devices are told of them. */
final class HomeDevice {

  private HomeDevice() {}

  /** The device of that id, if the home has it. */
  static Device named(String id, Home home) {
    Device device = home.devices().get(id);
    if (device == null) {
      throw CommandException.badInput(
          "The home has no device %s; it has %s."
              .formatted(id, String.join(", ", home.devices().keySet())));
    }
    return device;
  }

  /** Reads {@code "X Y DEGREES"}. */
  static Stance standing(String at) {
    String[] numbers = at.strip().split("\\s+");
    try {
      if (numbers.length == 3) {
        return new Stance(
            new Point2(Double.parseDouble(numbers[0]), Double.parseDouble(numbers[1])),
            Math.toRadians(Double.parseDouble(numbers[2])));
      }
    } catch (NumberFormatException e) {
      throw notAPlace(at);
    }
    throw notAPlace(at);
  }

  private static CommandException notAPlace(String at) {
    return CommandException.badInput(
        "\"%s\" is no place to stand; write metres and degrees, such as --at \"3 2 90\"."
            .formatted(at));
  }
}
