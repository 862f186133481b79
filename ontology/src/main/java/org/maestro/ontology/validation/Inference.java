package org.maestro.ontology.validation;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.Triple;
import org.apache.jena.vocabulary.OWL;
import org.apache.jena.vocabulary.RDF;
import org.apache.jena.vocabulary.RDFS;

/**
 * Adds to a graph what follows from subclass, subproperty, equivalent, inverse, symmetric and
 * transitive declarations and from restrictions to a value, until nothing new follows; and what a
 * class says of each of its individuals, of those that are told nothing else. New statements come
 * in a stable order; their origin is the statement that they follow from.
 */
public final class Inference {

  private static final Node TYPE = RDF.type.asNode();
  private static final Node SUBCLASS = RDFS.subClassOf.asNode();
  private static final Node SUBPROPERTY = RDFS.subPropertyOf.asNode();
  private static final Node EACH = Maestro.term("each");
  private static final Node INVERSE = OWL.inverseOf.asNode();
  private static final Set<Node> EQUIVALENT =
      Set.of(OWL.equivalentClass.asNode(), OWL.equivalentProperty.asNode());

  private final SourceGraph graph;

  public Inference(SourceGraph graph) {
    this.graph = graph;
  }

  public void run() {
    settle();
    takeFromClasses();
    settle();
  }

  /** The class with the most ancestors goes first, so that what it says stands. */
  private void takeFromClasses() {
    List<Node> telling = new ArrayList<>(graph.subjectsWith(EACH));
    telling.sort(
        Comparator.comparingInt((Node type) -> -graph.objects(type, SUBCLASS).size())
            .thenComparing(Nodes::localName));
    for (Node type : telling) {
      for (Node individual : List.copyOf(graph.subjects(TYPE, type))) {
        takeFrom(type, individual);
      }
    }
  }

  private void takeFrom(Node type, Node individual) {
    Set<Node> told = Set.copyOf(graph.predicates(individual));
    for (Node values : graph.objects(type, EACH)) {
      for (Node property : graph.predicates(values)) {
        if (!told.contains(property)) {
          for (Node value : graph.objects(values, property)) {
            graph.infer(
                Triple.create(individual, property, value),
                graph.originOf(Triple.create(values, property, value)));
          }
        }
      }
    }
  }

  private void settle() {
    List<Derived> fresh = round();
    while (!fresh.isEmpty()) {
      fresh.forEach(derived -> graph.infer(derived.triple(), derived.origin()));
      fresh = round();
    }
  }

  private List<Derived> round() {
    Map<Triple, Derived> derived = new LinkedHashMap<>();
    List<Derived> found = new ArrayList<>();
    graph.forEach(
        (triple, origin) -> {
          consequences(triple, origin, found);
          found.stream()
              .filter(one -> !graph.contains(one.triple()))
              .forEach(one -> derived.putIfAbsent(one.triple(), one));
          found.clear();
        });
    return derived.values().stream()
        .sorted(Comparator.comparingInt(one -> one.origin().line()))
        .toList();
  }

  private void consequences(Triple triple, SourceGraph.Origin origin, List<Derived> derived) {
    Node s = triple.getSubject();
    Node p = triple.getPredicate();
    Node o = triple.getObject();
    if (p.equals(TYPE) || p.equals(SUBCLASS)) {
      graph.objects(o, SUBCLASS).forEach(wider -> derived.add(derived(s, p, wider, origin)));
    }
    if (p.equals(SUBPROPERTY)) {
      graph.objects(o, SUBPROPERTY).forEach(wider -> derived.add(derived(s, p, wider, origin)));
    }
    if (EQUIVALENT.contains(p)) {
      Node narrower = p.equals(OWL.equivalentClass.asNode()) ? SUBCLASS : SUBPROPERTY;
      derived.add(derived(s, narrower, o, origin));
      derived.add(derived(o, narrower, s, origin));
    }
    for (Node wider : graph.objects(p, SUBPROPERTY)) {
      derived.add(derived(s, wider, o, origin));
    }
    for (Node restriction : graph.subjects(OWL.onProperty.asNode(), p)) {
      if (graph.objects(restriction, OWL.hasValue.asNode()).contains(o)) {
        derived.add(derived(s, TYPE, restriction, origin));
      }
    }
    if (o.isLiteral()) {
      return;
    }
    for (Node inverse : graph.objects(p, INVERSE)) {
      derived.add(derived(o, inverse, s, origin));
    }
    for (Node inverse : graph.subjects(INVERSE, p)) {
      derived.add(derived(o, inverse, s, origin));
    }
    if (graph.isA(p, OWL.SymmetricProperty.asNode())) {
      derived.add(derived(o, p, s, origin));
    }
    if (graph.isA(p, OWL.TransitiveProperty.asNode())) {
      graph.objects(o, p).forEach(next -> derived.add(derived(s, p, next, origin)));
    }
  }

  private static Derived derived(Node s, Node p, Node o, SourceGraph.Origin origin) {
    return new Derived(Triple.create(s, p, o), origin);
  }

  private record Derived(Triple triple, SourceGraph.Origin origin) {}
}
