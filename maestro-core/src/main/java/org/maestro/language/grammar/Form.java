package org.maestro.language.grammar;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/**
 * What words mean before a world is looked at: a head with parts, such as {@code (np the (noun
 * Lamp))}. A leaf is a symbol or a text.
 */
public record Form(String head, List<Form> parts) {
  /** The place of what was not said yet. */
  public static final Form HOLE = leaf("_");

  public Form {
    parts = List.copyOf(parts);
  }

  public static Form leaf(String text) {
    return new Form(text, List.of());
  }

  public static Form of(String head, Form... parts) {
    return new Form(head, Arrays.asList(parts));
  }

  public boolean is(String name) {
    return head.equals(name);
  }

  public Form part(int index) {
    return index < parts.size() ? parts.get(index) : HOLE;
  }

  /** The text of a part that is a leaf. */
  public String text(int index) {
    return part(index).head;
  }

  @Override
  public String toString() {
    return parts.isEmpty()
        ? head
        : parts.stream()
            .map(Form::toString)
            .collect(Collectors.joining(" ", "(" + head + " ", ")"));
  }
}
