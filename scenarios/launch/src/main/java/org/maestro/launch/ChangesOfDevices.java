package org.maestro.launch;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.assembly.LocalSite;
import org.maestro.console.truth.TrueThing;
import org.maestro.hal.Settings;
import org.maestro.hal.Switch;
import org.maestro.ontology.home.Individual;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * How lamps, doors and appliances of a simulated home truly are, and what of that has changed. One
 * thread.
 */
final class ChangesOfDevices {
  private final LocalSite site;
  private final SimulatedTruth truth;
  private Map<String, String> before;

  ChangesOfDevices(LocalSite site) {
    this.site = site;
    this.truth = SimulatedTruth.of(site);
    this.before = now();
  }

  /** What has changed since this was asked last, a line each. */
  List<String> since() {
    Map<String, String> now = now();
    List<String> changes = new ArrayList<>();
    now.forEach(
        (what, value) -> {
          if (!value.equals(before.get(what))) {
            changes.add(what + ": " + value);
          }
        });
    before = now;
    return changes;
  }

  private Map<String, String> now() {
    Map<String, String> now = new TreeMap<>();
    for (TrueThing thing : truth.now()) {
      thing.level().ifPresent(level -> now.put(label(thing.name()), percent(level)));
      thing.open().ifPresent(open -> now.put(label(thing.name()), open ? "open" : "closed"));
    }
    for (String device : site.simulated().devices()) {
      site.simulated()
          .drivers(device)
          .find(Switch.class)
          .ifPresent(power -> now.put(label(device), power.isOn() ? "on" : "off"));
      settings(device)
          .forEach((name, value) -> now.put(label(device) + ", " + name, inWords(value)));
    }
    return now;
  }

  private static String percent(double level) {
    return String.format(Locale.ROOT, "%.0f %%", level * 100);
  }

  private Map<String, Term> settings(String device) {
    return site.simulated()
        .drivers(device)
        .find(Settings.class)
        .map(Settings::values)
        .orElse(Map.of());
  }

  private String inWords(Term value) {
    return value instanceof Term.Name name ? label(name.text()) : SlPrinter.print(value);
  }

  private String label(String name) {
    return Optional.ofNullable(site.home().individuals().get(name))
        .map(Individual::label)
        .orElse(name);
  }

  /** What a device is set to; "" where it is not. */
  String value(String device, String setting) {
    return Optional.ofNullable(settings(device).get(setting)).map(SlPrinter::print).orElse("");
  }

  /** The appliances that are on, as people call them. */
  List<String> on() {
    List<String> on = new ArrayList<>();
    for (String device : site.simulated().devices()) {
      if (site.simulated().drivers(device).find(Switch.class).filter(Switch::isOn).isPresent()) {
        on.add(label(device));
      }
    }
    return on;
  }
}
