package org.maestro.coordination.api;

import java.util.Comparator;

/**
 * Something that goals contend for.
 *
 * @param owner the member whose component it is, or the individual; empty for a fact
 * @param part the component, or the fact in words; empty for an individual
 */
public record Resource(Kind kind, String owner, String part) implements Comparable<Resource> {
  private static final Comparator<Resource> ORDER =
      Comparator.comparing(Resource::kind)
          .thenComparing(Resource::owner)
          .thenComparing(Resource::part);

  /** The kind of thing that a resource is. */
  public enum Kind {
    /** A part of a member, had by one goal from the first step that uses it to the last. */
    COMPONENT,
    /** A thing or place that a step has for itself while it runs. */
    INDIVIDUAL,
    /** Something that is so and has to stay so. */
    FACT,
    /** That another goal is over. */
    END
  }

  public static Resource component(String member, String component) {
    return new Resource(Kind.COMPONENT, member, component);
  }

  public static Resource individual(String name) {
    return new Resource(Kind.INDIVIDUAL, name, "");
  }

  public static Resource fact(String inWords) {
    return new Resource(Kind.FACT, "", inWords);
  }

  public static Resource endOf(String goalId) {
    return new Resource(Kind.END, goalId, "");
  }

  /** For people. */
  public String inWords() {
    return switch (kind) {
      case COMPONENT -> "the " + part + " of " + owner;
      case INDIVIDUAL -> owner;
      case FACT -> part;
      case END -> "the end of " + owner;
    };
  }

  @Override
  public int compareTo(Resource other) {
    return ORDER.compare(this, other);
  }
}
