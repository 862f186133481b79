package org.maestro.knowledge.api;

import java.util.List;
import java.util.Set;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/**
 * What a member is at, by its own word: a part of the environment's state (Three-layered
 * architecture, 3.2.2; M49).
 *
 * @param state its abstract state, z
 * @param busy whether a call is under way in it
 */
public record MemberCondition(String state, boolean busy) {
  private static final String STATE = "memberState";
  private static final String BUSY = "busy";
  private static final String LOST = "lost";
  private static final String WAITED_FOR = "waitedFor";

  /** The words of facts about it. */
  private static final Set<String> WORDS = Set.of(STATE, BUSY, LOST, WAITED_FOR);

  /** The condition in facts. */
  public List<Fact> facts(String member) {
    Term name = new Term.Name(member);
    Formula.Atom itsBusy = new Formula.Atom(BUSY, List.of(name));
    return List.of(
        new Fact.Holds(new Formula.Atom(STATE, List.of(name, new Term.Text(state)))),
        busy ? new Fact.Holds(itsBusy) : new Fact.Excluded(itsBusy),
        new Fact.Excluded(lost(member)));
  }

  /** That the member is there no more. */
  public static Formula.Atom lost(String member) {
    return new Formula.Atom(LOST, List.of(new Term.Name(member)));
  }

  /** That a goal waits for the member, which does not do just now what is needed of it. */
  public static Formula.Atom waitedFor(String member) {
    return new Formula.Atom(WAITED_FOR, List.of(new Term.Name(member)));
  }

  /** Whether these facts, in MAESTRO-SL, speak of nothing but conditions of members. */
  public static boolean isAllOf(List<String> facts) {
    return !facts.isEmpty()
        && facts.stream().allMatch(fact -> WORDS.stream().anyMatch(word -> isOf(word, fact)));
  }

  private static boolean isOf(String word, String fact) {
    Fact read = SlParser.fact(fact);
    return read instanceof Fact.Holds holds && holds.atom().predicate().equals(word)
        || read instanceof Fact.Excluded excluded && excluded.atom().predicate().equals(word)
        || read instanceof Fact.Unknown unknown && unknown.atom().predicate().equals(word);
  }
}
