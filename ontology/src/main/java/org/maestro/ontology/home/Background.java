package org.maestro.ontology.home;

import java.util.List;
import java.util.Set;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.OWL;
import org.apache.jena.vocabulary.RDF;
import org.apache.jena.vocabulary.RDFS;
import org.jspecify.annotations.Nullable;
import org.maestro.ontology.validation.Inference;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;

/**
 * Statements of the shipped vocabulary, the alignments and the home about the words that a
 * description uses: read when first needed, then kept. Safe for threads.
 */
final class Background {

  private static final Set<Node> ABOUT_WORDS =
      Set.of(
          RDFS.subClassOf.asNode(),
          RDFS.subPropertyOf.asNode(),
          OWL.equivalentClass.asNode(),
          OWL.equivalentProperty.asNode(),
          OWL.onProperty.asNode(),
          OWL.hasValue.asNode());
  private static final Node OFFERS = Maestro.term("offers");

  private final String ownWords;
  private @Nullable Known known;

  private record Known(SourceGraph statements, SourceGraph aboutWords, SourceGraph ofHome) {}

  /**
   * @param ownWords what the home adds to the vocabulary that is shipped, as Turtle
   */
  Background(String ownWords) {
    this.ownWords = ownWords;
  }

  /**
   * Adds to the description what follows from its words, and, when it offers nothing, what its
   * classes offer.
   *
   * @param alignment how others call what is said of words
   */
  void explain(SourceGraph description, Node member, Alignment alignment) {
    Known known = known();
    description.copyMapped(known.aboutWords(), alignment::meaning);
    new Inference(description).run();
    if (description.objects(member, OFFERS).isEmpty()) {
      for (Node type : List.copyOf(description.objects(member, RDF.type.asNode()))) {
        description.copyAbout(type, known.statements());
      }
    }
  }

  /** Whether the word is one of another vocabulary of which is known what it means. */
  boolean explains(Node word) {
    return !known().aboutWords().predicates(word).isEmpty();
  }

  /** What the home states of words, its own and those of others. */
  SourceGraph ofHome() {
    return known().ofHome();
  }

  private synchronized Known known() {
    if (known == null) {
      SourceGraph statements = HomeLoader.statementsWith(ownWords);
      SourceGraph aboutWords = new SourceGraph();
      aboutWords.copy(statements, triple -> ABOUT_WORDS.contains(triple.getPredicate()));
      SourceGraph ofHome = new SourceGraph();
      ofHome.copyOf(
          HomeLoader.OWN_WORDS, statements, triple -> ABOUT_WORDS.contains(triple.getPredicate()));
      known = new Known(statements, aboutWords, ofHome);
    }
    return known;
  }
}
