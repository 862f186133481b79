package org.maestro.ontology.vocabulary;

import java.util.Collections;
import java.util.Set;
import java.util.TreeSet;

/** A class with all its superclasses by local name, itself included. */
public record ClassDeclaration(String name, String iri, String label, Set<String> ancestors) {
  public ClassDeclaration {
    ancestors = Collections.unmodifiableSet(new TreeSet<>(ancestors));
  }

  /** The same without what people read. */
  ClassDeclaration unlabelled() {
    return new ClassDeclaration(name, iri, "", ancestors);
  }
}
