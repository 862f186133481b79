package org.maestro.device;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.device.tasks.Numbers;
import org.maestro.hal.Drivers;
import org.maestro.hal.GripperArm;
import org.maestro.ontology.home.Device;
import org.maestro.sl.Term;

/**
 * The ratings of a device's hardware, as its drivers know them: numbers that never change. They
 * become part of what the device says of itself, under the names that its features have for them,
 * so that nobody plans what is beyond it.
 */
public final class Nameplate {

  private Nameplate() {}

  /** The device with the numbers of its drivers, where nothing else is stated. */
  public static Device on(Device device, Drivers drivers) {
    Map<String, List<Term>> numbers = new TreeMap<>();
    words(drivers)
        .forEach(
            (word, number) ->
                property(device, word)
                    .ifPresent(name -> numbers.put(name, List.of(new Term.Number(number)))));
    return numbers.isEmpty() ? device : device.with(numbers);
  }

  private static Map<String, Double> words(Drivers drivers) {
    Map<String, Double> words = new TreeMap<>();
    drivers
        .find(GripperArm.class)
        .ifPresent(arm -> words.put("grip", Numbers.millimetres(arm.opening())));
    return words;
  }

  private static Optional<String> property(Device device, String word) {
    return device
        .propertyCalled(word)
        .filter(name -> !device.individual().properties().containsKey(name));
  }
}
