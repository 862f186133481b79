package org.maestro.ontology.home;

import jakarta.json.Json;
import jakarta.json.JsonArrayBuilder;
import jakarta.json.JsonBuilderFactory;
import jakarta.json.JsonObjectBuilder;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.vocabulary.Claim;
import org.maestro.ontology.vocabulary.Doubt;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.ontology.vocabulary.Timing;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.SlPrinter;

/**
 * Writes a feature as part of a description: by its type's name where it is as the vocabulary says,
 * else whole.
 */
final class FeatureWriter {
  /** Made once: {@link Json} searches all jars for its provider each time that it is asked. */
  static final JsonBuilderFactory JSON = Json.createBuilderFactory(Map.of());

  private static final String XSD = "http://www.w3.org/2001/XMLSchema#";

  private final Vocabulary vocabulary;
  private final UnaryOperator<String> properties;

  /**
   * @param properties gives a property's IRI by its local name
   */
  FeatureWriter(Vocabulary vocabulary, UnaryOperator<String> properties) {
    this.vocabulary = vocabulary;
    this.properties = properties;
  }

  JsonObjectBuilder write(FeatureType feature, int order) {
    FeatureType known = vocabulary.features().get(feature.name());
    JsonObjectBuilder json = JSON.createObjectBuilder();
    if (known == null) {
      json.add("id", feature.iri());
      json.add("type", Maestro.NAMESPACE + (feature.task() ? "Task" : "Action"));
    } else {
      json.add("type", feature.iri());
    }
    json.add("order", order);
    if (!feature.equals(known)) {
      addAll(json, feature);
    }
    return json;
  }

  private void addAll(JsonObjectBuilder json, FeatureType feature) {
    json.add("sentence", feature.sentence());
    json.add("procedure", feature.procedure());
    json.add("input", parameters(feature.inputs()));
    json.add("binds", parameters(feature.binds()));
    json.add("output", parameters(feature.outputs()));
    json.add("precondition", SlPrinter.print(feature.precondition()));
    json.add("effect", SlPrinter.print(feature.effect()));
    feature.learns().ifPresent(learns -> json.add("learns", SlPrinter.print(learns)));
    json.add("continuous", feature.continuous());
    feature.endedBy().ifPresent(name -> json.add("endedBy", featureIri(name)));
    feature.frequencyHertz().ifPresent(hertz -> json.add("frequency", hertz));
    json.add("occupies", JSON.createArrayBuilder(feature.occupies()));
    json.add("claims", claims(feature.claims()));
    json.add("confidence", doubts(feature.doubts()));
    if (feature.cost() instanceof Price.Stated stated) {
      json.add("cost", SlPrinter.print(stated.cost()));
    } else if (feature.cost() instanceof Price.Asked asked) {
      json.add("cost", JSON.createObjectBuilder().add("id", Maestro.NAMESPACE + "asked"));
      json.add("costAtLeast", SlPrinter.print(asked.atLeast()));
    }
    json.add("seconds", SlPrinter.print(feature.seconds()));
    Timing timing = feature.timing();
    timing.limit().ifPresent(limit -> json.add("timeLimit", seconds(limit)));
    timing.grace().ifPresent(grace -> json.add("grace", seconds(grace)));
    timing.meanwhile().ifPresent(needed -> json.add("meanwhile", SlPrinter.print(needed)));
    timing.doneWhen().ifPresent(when -> json.add("doneWhen", SlPrinter.print(when)));
    timing.effectAfter().ifPresent(after -> json.add("effectAfter", seconds(after)));
    feature.reliability().chance().ifPresent(chance -> json.add("chance", chance));
    feature.reliability().statedTries().ifPresent(tries -> json.add("tries", tries));
    feature.exit().ifPresent(exit -> json.add("exit", exit));
    json.add("refersTo", namedFacts(feature.refersTo()));
  }

  static JsonArrayBuilder namedFacts(Map<String, String> facts) {
    JsonArrayBuilder json = JSON.createArrayBuilder();
    facts.forEach(
        (name, fact) -> json.add(JSON.createObjectBuilder().add("name", name).add("fact", fact)));
    return json;
  }

  private static JsonArrayBuilder claims(List<Claim> claims) {
    JsonArrayBuilder json = JSON.createArrayBuilder();
    for (Claim claim : claims) {
      json.add(
          JSON.createObjectBuilder()
              .add("variable", SlPrinter.print(claim.variable()))
              .add("when", SlPrinter.print(claim.when())));
    }
    return json;
  }

  private static JsonArrayBuilder doubts(List<Doubt> doubts) {
    JsonArrayBuilder json = JSON.createArrayBuilder();
    for (Doubt doubt : doubts) {
      json.add(
          JSON.createObjectBuilder()
              .add("upTo", doubt.confidence())
              .add("when", SlPrinter.print(doubt.when())));
    }
    return json;
  }

  private JsonArrayBuilder parameters(List<Parameter> parameters) {
    JsonArrayBuilder json = JSON.createArrayBuilder();
    for (Parameter parameter : parameters) {
      JsonObjectBuilder entry = JSON.createObjectBuilder().add("name", parameter.name());
      JsonArrayBuilder types = JSON.createArrayBuilder();
      parameter.types().forEach(type -> types.add(typeIri(type)));
      JsonArrayBuilder values = JSON.createArrayBuilder();
      parameter.oneOf().forEach(value -> DescriptionWriter.addLiteral(values, value));
      JsonArrayBuilder needs = JSON.createArrayBuilder();
      parameter.needs().forEach(need -> needs.add(properties.apply(need)));
      json.add(
          entry
              .add("types", types)
              .add("oneOf", values)
              .add("needs", needs)
              .add("optional", parameter.optional()));
    }
    return json;
  }

  private String typeIri(String name) {
    if (vocabulary.classes().containsKey(name)) {
      return vocabulary.classes().get(name).iri();
    }
    return (Parameter.OWN_DATATYPES.contains(name) ? Maestro.NAMESPACE : XSD) + name;
  }

  private String featureIri(String name) {
    return vocabulary.features().containsKey(name)
        ? vocabulary.features().get(name).iri()
        : Maestro.NAMESPACE + name;
  }

  private static double seconds(Duration time) {
    return time.toMillis() / 1000.0;
  }
}
