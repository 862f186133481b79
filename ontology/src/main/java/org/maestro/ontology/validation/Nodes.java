package org.maestro.ontology.validation;

import org.apache.jena.graph.Node;

/** RDF nodes as text for people. */
final class Nodes {

  private Nodes() {}

  static String localName(Node node) {
    return node.isURI() ? Maestro.localName(node.getURI()) : "a node without name";
  }

  static String shown(Node node) {
    if (node.isLiteral()) {
      return "\"" + node.getLiteralLexicalForm() + "\"";
    }
    return localName(node);
  }
}
