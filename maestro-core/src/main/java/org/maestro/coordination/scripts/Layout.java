package org.maestro.coordination.scripts;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.coordination.api.ScriptStep;
import org.maestro.sl.Body;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * The steps of a body as they are written, one line each, at the places that the parts for them
 * have. Of what is done again and again there is one round, and of another script that is run no
 * line before it is.
 */
final class Layout {
  private static final String NOTHING = "";

  private final List<ScriptStep> lines = new ArrayList<>();

  private Layout() {}

  /** Of the step and all that is in it. */
  static List<ScriptStep> of(Body body, String path, int depth) {
    Layout layout = new Layout();
    layout.add(body, path, depth, NOTHING);
    return layout.lines;
  }

  /** Of steps one after the other, without a line for these as a whole. */
  static List<ScriptStep> inTurn(List<Body> steps, String path, int depth) {
    Layout layout = new Layout();
    layout.addInTurn(steps, path, depth);
    return layout.lines;
  }

  private void addInTurn(List<Body> steps, String path, int depth) {
    for (int i = 0; i < steps.size(); i++) {
      add(steps.get(i), Place.below(path, i + 1), depth, NOTHING);
    }
  }

  /**
   * @param role of the step in the one that it is in
   */
  private void add(Body body, String path, int depth, String role) {
    lines.add(new ScriptStep(path, depth, role + SlPrinter.head(body)));
    int within = depth + 1;
    if (body instanceof Body.Seq || body instanceof Body.Par) {
      addInTurn(body.parts(), path, within);
    } else if (body instanceof Body.If choice) {
      add(choice.then(), Place.below(path, Choice.THEN), within, NOTHING);
      choice
          .otherwise()
          .ifPresent(other -> add(other, Place.below(path, Choice.OTHERWISE), within, "else "));
    } else if (body instanceof Body.While || body instanceof Body.ForEach) {
      add(body.parts().get(0), Place.below(path, 1), within, NOTHING);
    } else if (body instanceof Body.Let let) {
      if (let.source() instanceof Body.Run run) {
        add(run, Place.below(path, Let.SOURCE), within, NOTHING);
      }
      addInTurn(let.parts(), Place.below(path, Let.PARTS), within);
    } else if (body instanceof Body.Try attempt) {
      addTry(attempt, path, within);
    } else if (body instanceof Body.Hold hold) {
      addInTurn(hold.parts(), Place.below(path, Holding.STEPS), within);
    } else if (body instanceof Body.Ask ask) {
      // What comes after a question knows the answer; it is not a step of the question to people.
      addInTurn(ask.parts(), Place.below(path, Asking.PARTS), depth);
    }
  }

  private void addTry(Body.Try attempt, String path, int depth) {
    add(attempt.body(), Place.below(path, Attempt.TRIED), depth, NOTHING);
    for (int i = 0; i < attempt.recoveries().size(); i++) {
      Body.Recovery recovery = attempt.recoveries().get(i);
      Optional<String> reason = recovery.reason().map(text -> SlPrinter.print(new Term.Text(text)));
      add(
          recovery.body(),
          Place.below(path, Attempt.RECOVERIES + i),
          depth,
          "recover " + reason.map(text -> text + " ").orElse(""));
    }
    attempt.last().ifPresent(last -> add(last, Place.below(path, Attempt.LAST), depth, "finally "));
  }
}
