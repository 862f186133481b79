package org.maestro.rats.faults;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;

/** What a caller is told at the end of a call. */
final class Outcomes implements RatsLink.CallListener {

  final List<Result> results = new CopyOnWriteArrayList<>();

  @Override
  public void ended(Result result) {
    results.add(result);
  }

  boolean ended() {
    return !results.isEmpty();
  }

  boolean succeeded() {
    return ended() && results.get(0).outcome() == Outcome.SUCCEEDED;
  }
}
