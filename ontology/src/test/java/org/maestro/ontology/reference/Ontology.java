package org.maestro.ontology.reference;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.apache.jena.rdf.model.Model;
import org.apache.jena.rdf.model.ModelFactory;
import org.apache.jena.rdf.model.Property;
import org.apache.jena.rdf.model.Resource;
import org.apache.jena.riot.Lang;
import org.apache.jena.riot.RDFParser;
import org.apache.jena.vocabulary.RDF;
import org.apache.jena.vocabulary.RDFS;
import org.maestro.ontology.home.Home;

/** The shipped vocabularies and shapes, in the order and below the headings of their files. */
final class Ontology {
  static final String MAESTRO = "https://w3id.org/maestro#";

  private static final List<String> VOCABULARIES =
      List.of("maestro.ttl", "domain.ttl", "household.ttl");
  private static final List<String> SHAPES = List.of("shapes.ttl", "usual.ttl");
  private static final Pattern LINE =
      Pattern.compile("^(?:# --- (.+)|((?:maestro)?:\\w+) .*)$", Pattern.MULTILINE);

  private final Model model = ModelFactory.createDefaultModel();
  private final List<Section> sections = new ArrayList<>();

  Ontology() {
    for (String file : VOCABULARIES) {
      read(model, file);
    }
    Model shapes = ModelFactory.createDefaultModel();
    SHAPES.forEach(file -> read(shapes, file));
    Traits traits =
        new Traits(model, new Shapes(shapes, this::name), Examples.shipped(model), this::name);
    VOCABULARIES.forEach(file -> addSections(text(file), traits));
  }

  List<Section> sections() {
    return List.copyOf(sections);
  }

  /** The names of all that is declared with a type of its own. */
  List<String> declared() {
    TreeSet<String> names = new TreeSet<>();
    model
        .listSubjectsWithProperty(RDFS.comment)
        .filterKeep(Resource::isURIResource)
        .filterKeep(node -> node.getURI().contains("#"))
        .filterKeep(node -> node.hasProperty(RDF.type))
        .forEach(node -> names.add(name(node)));
    return List.copyOf(names);
  }

  static Property term(String name) {
    return ModelFactory.createDefaultModel().createProperty(MAESTRO, name);
  }

  /** As homes write it: without a prefix's name in the domain, where that is their usual prefix. */
  String name(Resource node) {
    return Optional.ofNullable(model.shortForm(node.getURI())).orElseThrow();
  }

  private void addSections(String text, Traits traits) {
    Matcher line = LINE.matcher(text);
    while (line.find()) {
      if (line.group(1) != null) {
        sections.add(new Section(line.group(1), new ArrayList<>()));
      } else {
        Resource node = model.createResource(model.expandPrefix(line.group(2)));
        sections.get(sections.size() - 1).words().add(word(node, traits));
      }
    }
  }

  private Word word(Resource node, Traits traits) {
    return new Word(
        node, name(node), said(node, RDFS.label), said(node, RDFS.comment), traits.of(node));
  }

  private static String said(Resource node, Property property) {
    return node.hasProperty(property) ? node.getProperty(property).getString() : "";
  }

  private static void read(Model model, String file) {
    RDFParser.fromString(text(file), Lang.TURTLE).parse(model);
  }

  private static String text(String file) {
    try (InputStream in = Home.class.getResourceAsStream("/org/maestro/ontology/" + file)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(file, e);
    }
  }
}
