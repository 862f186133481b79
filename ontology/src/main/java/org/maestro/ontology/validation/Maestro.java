package org.maestro.ontology.validation;

import org.apache.jena.graph.Node;
import org.apache.jena.graph.NodeFactory;

/** Names of the meta-vocabulary as RDF nodes. */
public final class Maestro {

  public static final String NAMESPACE = "https://w3id.org/maestro#";

  private Maestro() {}

  /** The term with this local name, {@code maestro:name}. */
  public static Node term(String name) {
    return NodeFactory.createURI(NAMESPACE + name);
  }

  /** What stands after the last {@code #} or {@code /} of an IRI. */
  public static String localName(String iri) {
    return iri.substring(Math.max(iri.lastIndexOf('#'), iri.lastIndexOf('/')) + 1);
  }
}
