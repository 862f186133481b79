package org.maestro.ontology.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.apache.jena.rdf.model.Model;
import org.apache.jena.rdf.model.Property;
import org.apache.jena.rdf.model.RDFList;
import org.apache.jena.rdf.model.RDFNode;
import org.apache.jena.rdf.model.Resource;
import org.apache.jena.vocabulary.OWL;
import org.apache.jena.vocabulary.OWL2;
import org.apache.jena.vocabulary.RDF;
import org.apache.jena.vocabulary.RDFS;

/** What is to be known of a word: what it is said of, its values, who has to say it. */
final class Traits {
  private static final Property HAS = Ontology.term("has");
  private static final Property ARGUMENTS = Ontology.term("arguments");
  private final Model model;
  private final Shapes shapes;
  private final Examples examples;
  private final Function<Resource, String> names;
  private final Values values;

  Traits(Model model, Shapes shapes, Examples examples, Function<Resource, String> names) {
    this.model = model;
    this.shapes = shapes;
    this.examples = examples;
    this.names = names;
    this.values = new Values(shapes, names);
  }

  List<String> of(Resource word) {
    List<String> traits = new ArrayList<>();
    if (word.hasProperty(RDF.type, OWL.Class)) {
      ofClass(word, traits);
    } else if (word.hasProperty(Ontology.term("sentence"))) {
      listed("offered by", subjects(Ontology.term("offers"), word), traits);
      formula(word, "precondition", "needs: ", traits);
      formula(word, "effect", "brings about: ", traits);
    } else if (isProperty(word)) {
      ofProperty(word, traits);
    }
    examples.of(word).ifPresent(text -> traits.add("example: `" + text + "`"));
    return traits;
  }

  private static boolean isProperty(Resource word) {
    return word.hasProperty(RDF.type, RDF.Property) || word.hasProperty(ARGUMENTS);
  }

  private void ofClass(Resource word, List<String> traits) {
    listed("a kind of", objects(word, RDFS.subClassOf), traits);
    List<String> said =
        model
            .listSubjectsWithProperty(RDF.type)
            .filterKeep(node -> node.isURIResource() && isProperty(node) && Values.isStated(node))
            .mapWith(property -> said(property, names.apply(word)))
            .toList()
            .stream()
            .flatMap(Optional::stream)
            .sorted()
            .toList();
    if (!said.isEmpty()) {
      traits.add("may say: " + String.join(", ", said));
    }
    listed("offers", objects(word, Ontology.term("offers")), traits);
  }

  private void ofProperty(Resource word, List<String> traits) {
    Map<String, String> of = classes(word);
    if (!of.isEmpty()) {
      traits.add(
          of.entrySet().stream()
              .map(one -> link(one.getKey()) + one.getValue())
              .collect(Collectors.joining(", ", "of: ", "")));
    }
    traits.add("value: " + values.of(word));
    formula(word, "derivedWhen", "follows, and is never stated: ", traits);
    formula(word, "observedWhen", "decided by positions: ", traits);
    listed("computed by", objects(word, Ontology.term("computedBy")), traits);
    if (word.hasProperty(RDF.type, Ontology.term("Observable"))) {
      traits.add("found out by devices; unknown until then" + age(word));
    }
    shapes.complaints(word).forEach(message -> traits.add("else `check` says: " + message));
  }

  /** Of which classes the property is said, and to which degree they have to. */
  private Map<String, String> classes(Resource property) {
    Map<String, String> of = new TreeMap<>();
    domain(property).forEach(name -> of.put(name, ""));
    shapes.classes(property).forEach(name -> of.put(name, ""));
    subjects(HAS, property).forEach(name -> of.put(name, ""));
    shapes.demands(property).forEach((name, degree) -> of.put(name, " (" + degree + ")"));
    return of;
  }

  private Optional<String> said(Resource property, String className) {
    return Optional.ofNullable(classes(property).get(className))
        .map(degree -> link(names.apply(property)) + degree);
  }

  private static String age(Resource word) {
    Property validFor = Ontology.term("validFor");
    return word.hasProperty(validFor)
        ? ", and again after `" + word.getProperty(validFor).getString() + "`"
        : "";
  }

  private static void formula(Resource word, String property, String before, List<String> traits) {
    Property formula = Ontology.term(property);
    if (word.hasProperty(formula)) {
      traits.add(
          before + "`" + word.getProperty(formula).getString().replaceAll("\\s+", " ") + "`");
    }
  }

  private List<String> domain(Resource word) {
    List<String> domain = new ArrayList<>();
    List<String> arguments = Values.arguments(word);
    if (!arguments.isEmpty() && arguments.get(0).contains(" - ")) {
      String name = arguments.get(0).substring(arguments.get(0).indexOf(" - ") + 3);
      model
          .listSubjectsWithProperty(RDF.type, OWL.Class)
          .filterKeep(type -> type.isURIResource() && type.getLocalName().equals(name))
          .forEach(type -> domain.add(names.apply(type)));
    }
    for (RDFNode said : model.listObjectsOfProperty(word, RDFS.domain).toList()) {
      if (said.isURIResource()) {
        domain.add(names.apply(said.asResource()));
      } else {
        RDFNode union = said.asResource().getProperty(OWL2.unionOf).getObject();
        union
            .as(RDFList.class)
            .asJavaList()
            .forEach(one -> domain.add(names.apply(one.asResource())));
      }
    }
    return domain;
  }

  private void listed(String what, List<String> words, List<String> traits) {
    if (!words.isEmpty()) {
      traits.add(what + ": " + words.stream().map(Traits::link).collect(Collectors.joining(", ")));
    }
  }

  private List<String> objects(Resource word, Property property) {
    return model
        .listObjectsOfProperty(word, property)
        .filterKeep(RDFNode::isURIResource)
        .mapWith(node -> names.apply(node.asResource()))
        .toList()
        .stream()
        .sorted()
        .toList();
  }

  private List<String> subjects(Property property, Resource word) {
    return model
        .listSubjectsWithProperty(property, word)
        .filterKeep(RDFNode::isURIResource)
        .mapWith(names::apply)
        .toList()
        .stream()
        .sorted()
        .toList();
  }

  /** To where the page speaks of the word; {@link ReferencePage} knows where that is. */
  static String link(String name) {
    return "[[" + name + "]]";
  }
}
