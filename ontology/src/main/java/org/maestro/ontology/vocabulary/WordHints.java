package org.maestro.ontology.vocabulary;

import java.util.Collection;
import java.util.Optional;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.NodeFactory;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.validation.Nearest;
import org.maestro.ontology.validation.SourceGraph;

/** What to write in the place of a word that nobody knows, as the text itself would write it. */
public final class WordHints {

  private final SourceGraph graph;
  private final Vocabulary vocabulary;

  public WordHints(SourceGraph graph, Vocabulary vocabulary) {
    this.graph = graph;
    this.vocabulary = vocabulary;
  }

  /**
   * @param name local name of what was written
   * @param known local names of words
   * @param wanted what to do where none of them is near
   */
  public String cure(String name, Collection<String> known, String wanted) {
    return Nearest.cure(name, known, this::written, wanted);
  }

  /** The word with its prefix. */
  public String written(String name) {
    return vocabulary
        .iri(name)
        .map(NodeFactory::createURI)
        .or(() -> property(name))
        .map(graph::written)
        .orElse(name);
  }

  private Optional<Node> property(String name) {
    return graph.subjects(RDF.type.asNode(), RDF.Property.asNode()).stream()
        .filter(node -> Literals.name(node).equals(name))
        .findFirst();
  }
}
