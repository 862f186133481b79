package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.validation.Nearest;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.sl.Self;

/** What of a device's description is no fault, but hardly meant so. */
final class DeviceDoubts {

  private static final Pattern PLACE_HOLDER = Pattern.compile("\\{([^{}]*)}");

  private final Device device;
  private final String source;
  private final List<Fault> found = new ArrayList<>();

  private DeviceDoubts(Device device, String source) {
    this.device = device;
    this.source = source;
  }

  /**
   * @param source how they call the description
   */
  static List<Fault> of(Device device, String source) {
    return new DeviceDoubts(device, source).found();
  }

  private List<Fault> found() {
    if (device.features().isEmpty() && device.reports().isEmpty()) {
      warn(
          device.id(),
          "",
          "offers nothing, so that plans can only use what it tells of itself",
          "say what it can do, under offers, or what it tells, under reports");
    }
    for (FeatureType feature : device.features()) {
      checkSentence(feature);
      checkEnd(feature);
      checkChoice(feature);
      feature.inputs().forEach(input -> checkType(feature, input, "input"));
      feature.binds().forEach(bound -> checkType(feature, bound, "binds"));
    }
    return found;
  }

  private void checkSentence(FeatureType feature) {
    Set<String> known = new TreeSet<>(Set.of(Self.NAME));
    Stream.of(feature.inputs(), feature.binds(), feature.outputs())
        .flatMap(List::stream)
        .map(Parameter::name)
        .forEach(known::add);
    Matcher places = PLACE_HOLDER.matcher(feature.sentence());
    while (places.find()) {
      String name = places.group(1);
      if (!known.contains(name)) {
        warn(
            feature.name(),
            "sentence",
            "has the place holder {%s}, and no parameter is called so".formatted(name),
            Nearest.cure(
                name,
                known,
                other -> "{" + other + "}",
                known.stream()
                    .map(other -> "{" + other + "}")
                    .collect(Collectors.joining(", ", "write one of ", ""))));
      }
    }
  }

  private void checkEnd(FeatureType feature) {
    feature
        .endedBy()
        .filter(end -> device.features().stream().noneMatch(other -> other.name().equals(end)))
        .ifPresent(
            end ->
                warn(
                    feature.name(),
                    "endedBy",
                    "names %s, which %s does not offer".formatted(end, device.id()),
                    "offer it too, or name a feature that is offered"));
  }

  private void checkChoice(FeatureType feature) {
    OpenChoice.in(feature)
        .filter(parameter -> !parameter.types().isEmpty())
        .ifPresent(
            parameter ->
                warn(
                    feature.name(),
                    "oneOf",
                    "is not said of %s, so that no plan can choose a value and none has %s in it"
                        .formatted(parameter.name(), feature.name()),
                    "name the values that it may have, such as \"oneOf\": [1, 2, 5]"));
  }

  private void checkType(FeatureType feature, Parameter parameter, String property) {
    if (parameter.types().isEmpty() && parameter.oneOf().isEmpty()) {
      warn(
          feature.name(),
          property,
          "does not say of what class " + parameter.name() + " is",
          "write its types, such as [\"domain:Item\"]");
    }
  }

  private void warn(String subject, String property, String problem, String cure) {
    found.add(new Fault(source, 0, subject, property, problem, cure));
  }
}
