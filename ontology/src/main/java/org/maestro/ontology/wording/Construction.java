package org.maestro.ontology.wording;

import java.util.List;
import java.util.Optional;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * A pattern of words with roles, and what it means (ADE, 4.2). The first word is the verb in its
 * base form; roles stand in braces.
 *
 * @param name local name
 * @param says patterns, {@code put {object} {where}}; what stands in brackets may be left out
 * @param means the message, in which roles are variables; empty: it only tells what is so
 * @param holdsWhen what is so when it is told, or when it is waited for
 * @param early whether it may be begun before the sentence ends
 * @param confirm whether it is asked back always
 * @param inTheMorning whether it is usually wanted in the morning: of two times of the day that are
 *     called the same that one is meant
 */
public record Construction(
    String name,
    List<Said> says,
    List<Role> roles,
    Optional<Content> means,
    Optional<Formula> holdsWhen,
    boolean early,
    boolean confirm,
    boolean inTheMorning) {
  public Construction {
    says = List.copyOf(says);
    roles = List.copyOf(roles);
  }

  /**
   * A place in the pattern.
   *
   * @param type a class, {@code Relation}, {@code Condition}, or a datatype by local name: {@code
   *     decimal}, {@code duration}, {@code string}
   * @param relates of a relation: the role whose place it tells
   * @param questions what is asked when it is missing; other roles stand in braces
   * @param usually its value when it is not said
   * @param toTheEnd whether what fills it goes on until nothing more is said
   */
  public record Role(
      String name,
      String type,
      Optional<String> relates,
      List<Said> questions,
      boolean optional,
      Optional<Term> usually,
      boolean toTheEnd) {
    /** The type of a role that is told by a prepositional phrase. */
    public static final String RELATION = "Relation";

    /** The type of a role that is told by a sentence about what is so. */
    public static final String CONDITION = "Condition";

    public Role {
      questions = List.copyOf(questions);
    }
  }
}
