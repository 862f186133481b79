package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.NodeFactory;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.WordHints;

/**
 * What in a home is no fault, but hardly meant so: what is left unsaid, what nobody can be asked
 * for, what stands where it serves nobody.
 */
final class HomeDoubts {

  private final SourceGraph graph;
  private final Home home;
  private final WordHints words;

  /**
   * @param home without faults, as read from the graph
   */
  HomeDoubts(SourceGraph graph, Home home) {
    this.graph = graph;
    this.home = home;
    this.words = new WordHints(graph, home.vocabulary());
  }

  /** By line; what makes that the home cannot be run becomes faults of the graph. */
  List<Fault> found() {
    List<Fault> found = new ArrayList<>();
    HomeLoader.usualShapes().check(graph, found::add);
    UnstatedNeeds.all(home).forEach(need -> found.add(told(need)));
    ImpossibleUses.all(home).forEach(vain -> found.add(told(vain)));
    found.addAll(new MapDoubts(graph, home).found());
    found.sort(Comparator.comparing(Fault::line));
    return found;
  }

  private Fault told(UnstatedNeeds.Need need) {
    return graph.told(
        node(need.device().individual()),
        node(need.number()),
        Optional.empty(),
        "is not stated, and without it %s is never used to %s"
            .formatted(need.device().id(), need.feature().name()),
        "write %s with a number%s"
            .formatted(
                words.written(need.number()),
                home.vocabulary()
                    .predicate(need.number())
                    .map(PredicateDeclaration::unitAfterNumber)
                    .filter(unit -> !unit.isEmpty())
                    .map(unit -> " in" + unit)
                    .orElse("")));
  }

  private Fault told(ImpossibleUses.Vain vain) {
    return graph.told(
        node(vain.thing()),
        "is beyond everybody who offers %s: %s".formatted(vain.feature(), vain.reason()),
        "correct the numbers, or add a device that can");
  }

  private Node node(String word) {
    return NodeFactory.createURI(home.vocabulary().iri(word).orElse(word));
  }

  private static Node node(Individual thing) {
    return NodeFactory.createURI(thing.iri());
  }
}
