package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.stream.Stream;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.validation.JsonOutline;

/** Tells what would become of a description in a home, without anything of it being there. */
public final class DescriptionCheck {

  private final Home home;
  private final DeviceFile descriptions;

  /**
   * What would become of it.
   *
   * @param faults all that were found; with one of them it is refused
   * @param warnings what in it is hardly meant so
   * @param devices those that could join
   */
  public record Verdict(List<Fault> faults, List<Fault> warnings, List<Device> devices) {

    public Verdict {
      faults = List.copyOf(faults);
      warnings = List.copyOf(warnings);
      devices = List.copyOf(devices);
    }
  }

  /**
   * @param home as it is now, with what has joined
   * @param reader of single descriptions (first argument) of devices (second)
   */
  public DescriptionCheck(Home home, BiFunction<String, String, Device> reader) {
    this.home = home;
    this.descriptions =
        new DeviceFile(
            reader,
            name ->
                Optional.ofNullable(home.vocabulary().classes().get(name))
                    .filter(declared -> Extension.mayBring(declared.ancestors()))
                    .isPresent());
  }

  /**
   * Checks a text in Turtle or JSON-LD, of one device or several.
   *
   * @param source how faults call the text
   */
  public Verdict check(String text, String source) {
    List<Fault> faults = new ArrayList<>();
    List<Device> devices = new ArrayList<>();
    try {
      Home joined = home;
      for (DeviceFile.Described described : descriptions.read(text, source)) {
        Device device = described.device();
        Optional<Contradiction> contradiction = joined.contradiction(device);
        contradiction.ifPresent(it -> faults.add(it.fault(source, device.id())));
        if (contradiction.isEmpty()) {
          devices.add(device);
          joined = joined.with(device);
        }
      }
    } catch (HomeFaultException e) {
      faults.addAll(e.faults());
    }
    List<Fault> doubts =
        devices.stream().flatMap(device -> DeviceDoubts.of(device, source).stream()).toList();
    return DescriptionReader.isJson(text)
        ? placed(new Verdict(faults, doubts, devices), new JsonOutline(text, source))
        : new Verdict(faults, doubts, devices);
  }

  /** The verdict on a text in JSON, with lines, and with what it says in words of nobody. */
  private static Verdict placed(Verdict verdict, JsonOutline outline) {
    return new Verdict(
        byLine(verdict.faults().stream().map(outline::placed)),
        byLine(
            Stream.concat(
                outline.unknownWords().stream(), verdict.warnings().stream().map(outline::placed))),
        verdict.devices());
  }

  private static List<Fault> byLine(Stream<Fault> told) {
    return told.sorted(Comparator.comparing(Fault::line)).toList();
  }
}
