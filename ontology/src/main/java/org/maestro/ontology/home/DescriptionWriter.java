package org.maestro.ontology.home;

import static org.maestro.ontology.home.FeatureWriter.JSON;

import jakarta.json.JsonArrayBuilder;
import jakarta.json.JsonObject;
import jakarta.json.JsonObjectBuilder;
import java.math.BigDecimal;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceReader;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * Writes what a device of a home says of itself on the bus: its classes, properties and features,
 * features of the vocabulary by the name of their type. {@link DescriptionReader} makes an equal
 * device of it. The same device gives the same text. Safe for threads.
 */
public final class DescriptionWriter {

  private final Home home;
  private final FeatureWriter features;

  public DescriptionWriter(Home home) {
    this.home = home;
    this.features = new FeatureWriter(home.vocabulary(), this::property);
  }

  /** The description as one JSON-LD document. */
  public String write(Device device) {
    Individual individual = device.individual();
    JsonObjectBuilder json = JSON.createObjectBuilder();
    json.add("@context", context());
    json.add("id", individual.iri());
    json.add("type", types(individual));
    json.add("label", individual.label());
    device.container().ifPresent(container -> json.add("container", container));
    device.driver().ifPresent(driver -> json.add("driver", driver));
    for (Map.Entry<String, List<Term>> property : individual.properties().entrySet()) {
      JsonArrayBuilder values = JSON.createArrayBuilder();
      property.getValue().forEach(value -> add(values, value));
      json.add(property(property.getKey()), values);
    }
    if (!device.pursues().isEmpty()) {
      JsonArrayBuilder goals = JSON.createArrayBuilder();
      device.pursues().forEach(goal -> goals.add(SlPrinter.print(goal)));
      json.add("pursues", goals);
    }
    StatedWorth worth = device.worth();
    worth.benefit().ifPresent(benefit -> json.add("benefit", SlPrinter.print(benefit)));
    worth.chance().ifPresent(chance -> json.add("chance", chance));
    worth.allowed().ifPresent(time -> json.add("allowed", time.toString()));
    json.add("reports", FeatureWriter.namedFacts(device.reports()));
    if (!device.settings().isEmpty()) {
      json.add("setting", settings(device));
    }
    JsonArrayBuilder offers = JSON.createArrayBuilder();
    int order = 1;
    for (FeatureType feature : device.features()) {
      offers.add(features.write(feature, order++));
    }
    json.add("offers", offers);
    JsonObject document = json.build();
    return document.toString();
  }

  private JsonArrayBuilder settings(Device device) {
    JsonArrayBuilder json = JSON.createArrayBuilder();
    for (Setting setting : device.settings().values()) {
      JsonObjectBuilder entry = JSON.createObjectBuilder().add("name", setting.name());
      Optional.ofNullable(device.reports().get(setting.name()))
          .ifPresent(fact -> entry.add("fact", fact));
      setting.lowest().ifPresent(number -> entry.add("lowest", number));
      setting.highest().ifPresent(number -> entry.add("highest", number));
      setting.grain().ifPresent(number -> entry.add("grain", number));
      setting
          .atFirst()
          .ifPresent(
              value -> {
                JsonArrayBuilder values = JSON.createArrayBuilder();
                add(values, value);
                entry.add("atFirst", values);
              });
      json.add(entry.add("delay", setting.delaySeconds()).add("whileOn", setting.whileOn()));
    }
    return json;
  }

  private JsonArrayBuilder context() {
    return JSON.createArrayBuilder().add(SourceReader.CONTEXT_IRI);
  }

  /** The classes, most special first. */
  private JsonArrayBuilder types(Individual individual) {
    Vocabulary vocabulary = home.vocabulary();
    JsonArrayBuilder types = JSON.createArrayBuilder();
    individual.classes().stream()
        .sorted(
            Comparator.comparing(
                    (String name) ->
                        vocabulary.classes().containsKey(name)
                            ? -vocabulary.classes().get(name).ancestors().size()
                            : Integer.MIN_VALUE)
                .thenComparing(Comparator.naturalOrder()))
        .forEach(
            name ->
                types.add(
                    vocabulary.classes().containsKey(name)
                        ? vocabulary.classes().get(name).iri()
                        : own(name)));
    return types;
  }

  /** The IRI of a property of which only the local name is known. */
  private String property(String name) {
    return home.vocabulary()
        .predicate(name)
        .map(declared -> declared.iri())
        .orElse(Maestro.NAMESPACE + name);
  }

  private String own(String name) {
    return home.iri() + "#" + name;
  }

  private void add(JsonArrayBuilder values, Term value) {
    if (value instanceof Term.Name name) {
      Individual named = home.individuals().get(name.text());
      String iri = named == null ? own(name.text()) : named.iri();
      values.add(JSON.createObjectBuilder().add("id", iri));
    } else {
      addLiteral(values, value);
    }
  }

  static void addLiteral(JsonArrayBuilder values, Term value) {
    if (value instanceof Term.Number number) {
      values.add(new BigDecimal(SlPrinter.print(number.value())));
    } else if (value instanceof Term.Truth truth) {
      values.add(truth.value());
    } else if (value instanceof Term.Text text) {
      values.add(text.value());
    } else {
      values.add(SlPrinter.print(value));
    }
  }
}
