package org.maestro.language.grammar;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/** How a rule's meaning is made of what its parts mean. */
public sealed interface Template {
  /** A part by its label. */
  record Label(String name) implements Template {}

  /** A head with parts; parts whose label was not said are left out. */
  record Node(String head, List<Template> parts) implements Template {
    public Node {
      parts = List.copyOf(parts);
    }
  }

  /**
   * The meaning.
   *
   * @param bound what the labels mean; empty for one that was not said
   */
  default Optional<Form> apply(Function<String, Optional<Form>> bound) {
    if (this instanceof Label label) {
      return bound.apply(label.name());
    }
    Node node = (Node) this;
    List<Form> parts =
        node.parts().stream().map(part -> part.apply(bound)).flatMap(Optional::stream).toList();
    return Optional.of(new Form(node.head(), parts));
  }

  /**
   * Reads a form in brackets.
   *
   * @param labels of the rule; every other word is a head
   */
  static Template of(Form written, Set<String> labels) {
    return written.parts().isEmpty() && labels.contains(written.head())
        ? new Label(written.head())
        : new Node(written.head(), written.parts().stream().map(part -> of(part, labels)).toList());
  }
}
