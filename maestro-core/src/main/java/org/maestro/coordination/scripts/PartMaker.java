package org.maestro.coordination.scripts;

import java.util.function.Consumer;
import org.maestro.sl.Body;

/** Makes the parts of a script by the forms of its body, so that no part knows all others. */
interface PartMaker {

  /** Not begun yet. */
  Part part(Body body, Scope scope, Course course, String path, Consumer<Result> then);
}
