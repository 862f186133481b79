package org.maestro.agents.content;

import java.util.List;
import java.util.stream.Stream;
import org.maestro.ontology.home.DescriptionCheck;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Content;

/**
 * The verdict on a description in messages: its faults, what is hardly meant so, and the devices
 * that could join by it.
 */
public final class VerdictWords {

  /**
   * A device that could join.
   *
   * @param features their names
   */
  public record Joining(String device, List<String> features) {

    public static Joining of(Device device) {
      return new Joining(device.id(), device.features().stream().map(FeatureType::name).toList());
    }
  }

  private static final String PROBLEM = "problem";
  private static final String DOUBT = "doubt";

  private VerdictWords() {}

  /** One element for each fault, each warning and each device. */
  public static Stream<Content> contents(DescriptionCheck.Verdict verdict) {
    return Stream.of(
            verdict.faults().stream().map(fault -> told("fault", PROBLEM, fault)),
            verdict.warnings().stream().map(warning -> told("warning", DOUBT, warning)),
            verdict.devices().stream().map(Joining::of).map(VerdictWords::joining))
        .flatMap(elements -> elements);
  }

  private static Content told(String kind, String problem, Fault fault) {
    return Words.content(
        kind,
        Words.named("source", Words.text(fault.source())),
        Words.named("line", Words.number(fault.line())),
        Words.named("subject", Words.text(fault.subject())),
        Words.named("property", Words.text(fault.property())),
        Words.named(problem, Words.text(fault.problem())),
        Words.named("cure", Words.text(fault.cure())));
  }

  private static Content joining(Joining joining) {
    return Words.content(
        "device",
        Words.named("device", Words.text(joining.device())),
        Words.named("features", joining.features().stream().map(Words::text).toList()));
  }

  /** The faults among the elements of an answer. */
  public static List<Fault> faults(List<Words> elements) {
    return told(PROBLEM, elements);
  }

  /** The warnings among the elements of an answer. */
  public static List<Fault> warnings(List<Words> elements) {
    return told(DOUBT, elements);
  }

  private static List<Fault> told(String problem, List<Words> elements) {
    return elements.stream()
        .filter(element -> element.string(problem).isPresent())
        .map(
            element ->
                new Fault(
                    element.string("source").orElse(""),
                    (int) element.number("line", 0),
                    element.string("subject").orElse(""),
                    element.string("property").orElse(""),
                    element.string(problem).orElse(""),
                    element.string("cure").orElse("")))
        .toList();
  }

  /** The devices among the elements of an answer. */
  public static List<Joining> joining(List<Words> elements) {
    return elements.stream()
        .filter(element -> element.string("device").isPresent())
        .map(
            element ->
                new Joining(element.string("device").orElse(""), element.strings("features")))
        .toList();
  }
}
