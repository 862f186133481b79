package org.maestro.ontology.reference;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.jena.rdf.model.Literal;
import org.apache.jena.rdf.model.Model;
import org.apache.jena.rdf.model.ModelFactory;
import org.apache.jena.rdf.model.RDFList;
import org.apache.jena.rdf.model.RDFNode;
import org.apache.jena.rdf.model.Resource;
import org.apache.jena.rdf.model.Statement;
import org.apache.jena.riot.RDFDataMgr;
import org.apache.jena.vocabulary.RDF;

/** One statement with a word, from a shipped home, or from the vocabulary itself. */
final class Examples {
  private static final Path HOMES = Path.of("../scenarios/assembly/src/main/resources/homes");
  private static final int LONGEST = 160;

  private final List<Model> sources;

  private Examples(List<Model> sources) {
    this.sources = sources;
  }

  static Examples shipped(Model vocabulary) {
    List<Model> sources = new ArrayList<>();
    try (Stream<Path> files = Files.list(HOMES)) {
      // Bob's home is the one that people know.
      files
          .sorted(
              Comparator.comparing((Path file) -> !file.endsWith("bob.ttl"))
                  .thenComparing(file -> file))
          .map(file -> RDFDataMgr.loadModel(file.toString()))
          .forEach(sources::add);
    } catch (IOException e) {
      throw new UncheckedIOException("The shipped homes cannot be listed", e);
    }
    sources.add(vocabulary);
    return new Examples(sources);
  }

  Optional<String> of(Resource word) {
    return sources.stream().flatMap(source -> of(word, source).stream()).findFirst();
  }

  private static Optional<String> of(Resource word, Model source) {
    Stream<Statement> statements =
        Stream.of(
                source.listStatements(null, source.createProperty(word.getURI()), (RDFNode) null),
                source.listStatements(null, RDF.type, word))
            .flatMap(found -> found.toList().stream());
    return statements
        .filter(said -> said.getSubject().isURIResource())
        .flatMap(said -> turtle(said).stream())
        .filter(text -> text.length() <= LONGEST)
        .min(Comparator.naturalOrder());
  }

  private static Optional<String> turtle(Statement said) {
    Model model = said.getModel();
    return value(said.getObject(), model)
        .map(
            value ->
                "%s %s %s ."
                    .formatted(
                        shown(said.getSubject(), model),
                        said.getPredicate().equals(RDF.type)
                            ? "a"
                            : shown(said.getPredicate(), model),
                        value));
  }

  private static Optional<String> value(RDFNode node, Model model) {
    if (node.isLiteral()) {
      return Optional.of(literal(node.asLiteral()));
    }
    if (node.isURIResource()) {
      return Optional.of(shown(node.asResource(), model));
    }
    if (node.canAs(RDFList.class)) {
      List<Optional<String>> parts =
          node.as(RDFList.class).asJavaList().stream().map(part -> value(part, model)).toList();
      return parts.stream().allMatch(Optional::isPresent)
          ? Optional.of(
              parts.stream().flatMap(Optional::stream).collect(Collectors.joining(" ", "( ", " )")))
          : Optional.empty();
    }
    return Optional.empty();
  }

  private static String literal(Literal literal) {
    String type = literal.getDatatypeURI();
    if (type.endsWith("#decimal") || type.endsWith("#integer") || type.endsWith("#boolean")) {
      return literal.getLexicalForm();
    }
    String quoted = "\"" + literal.getLexicalForm().replaceAll("\\s+", " ") + "\"";
    return type.endsWith("#duration") ? quoted + "^^xsd:duration" : quoted;
  }

  private static String shown(Resource node, Model model) {
    String name = ModelFactory.createDefaultModel().setNsPrefixes(model).shortForm(node.getURI());
    return name.equals(node.getURI()) ? "<" + name + ">" : name;
  }
}
