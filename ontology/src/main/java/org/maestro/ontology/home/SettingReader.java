package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.apache.jena.graph.Node;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.sl.SlPrinter;

/** Reads what can be set at a device, and what of it features have to choose among. */
final class SettingReader {

  private static final Node SETTING = Maestro.term("setting");

  private final SourceGraph graph;
  private final Literals literals;

  SettingReader(SourceGraph graph) {
    this.graph = graph;
    this.literals = new Literals(graph);
  }

  /** What the node says of settings, over what holds without. */
  Map<String, Setting> read(Node node, Map<String, Setting> before) {
    Map<String, Setting> settings = new TreeMap<>(before);
    for (Node entry : graph.objects(node, SETTING)) {
      literals
          .text(entry, "name")
          .map(name -> setting(entry, name))
          .filter(setting -> isPossible(node, entry, setting))
          .ifPresent(setting -> settings.put(setting.name(), setting));
    }
    return settings;
  }

  private Setting setting(Node entry, String name) {
    return new Setting(
        name,
        literals.number(entry, "lowest"),
        literals.number(entry, "highest"),
        literals.number(entry, "grain"),
        graph.object(entry, Maestro.term("atFirst")).map(Literals::term),
        literals.number(entry, "delay").orElse(0),
        literals.flag(entry, "whileOn"));
  }

  private boolean isPossible(Node node, Node entry, Setting setting) {
    OptionalDouble count = setting.count();
    boolean isFew = count.isEmpty() || count.getAsDouble() <= Setting.MOST_VALUES;
    if (!isFew) {
      graph.fault(
          node,
          SETTING,
          Optional.of(entry),
          "gives %s %s values, more than %d"
              .formatted(setting.name(), SlPrinter.print(count.getAsDouble()), Setting.MOST_VALUES),
          "write a greater maestro:grain, or leave it away");
    }
    return isFew;
  }

  /** The feature, its inputs that name no values chosen among those of the settings they set. */
  static FeatureType choosing(FeatureType feature, Map<String, Setting> settings) {
    List<Parameter> inputs = new ArrayList<>();
    for (Parameter input : feature.inputs()) {
      Setting setting = settings.get(input.name());
      inputs.add(
          setting == null || input.hasChoice()
              ? input
              : new Parameter(
                  input.name(), input.types(), setting.values(), input.needs(), input.optional()));
    }
    return inputs.equals(feature.inputs()) ? feature : feature.withInputs(inputs);
  }
}
