package org.maestro.rats.broker;

import java.io.File;
import java.io.IOException;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Pattern;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.platform.commons.support.AnnotationSupport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The tests of the class start a program; where it is not installed they say so and do not run. */
@Target(ElementType.TYPE)
@Retention(RetentionPolicy.RUNTIME)
@ExtendWith(RunsProgram.Presence.class)
public @interface RunsProgram {

  /** The programs' names, as looked for on the path. */
  String[] value();

  /** What python3 must be able to import; empty: nothing. */
  String pythonModule() default "";

  /** Looks for programs. */
  final class Presence implements ExecutionCondition {

    private static final Logger LOG = LoggerFactory.getLogger("tests-that-need-a-program");

    /** Where the program is; system administrators' programs are off the path of most users. */
    static Optional<File> find(String program) {
      String path = System.getenv().getOrDefault("PATH", "") + File.pathSeparator + "/usr/sbin";
      return Pattern.compile(Pattern.quote(File.pathSeparator))
          .splitAsStream(path)
          .map(directory -> new File(directory, program))
          .filter(file -> file.isFile() && file.canExecute())
          .findFirst();
    }

    private static boolean imports(String module) {
      if (module.isEmpty()) {
        return true;
      }
      try {
        return new ProcessBuilder("python3", "-c", "import " + module)
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start()
                .waitFor()
            == 0;
      } catch (IOException none) {
        LOG.debug("There is no python3", none);
        return false;
      } catch (InterruptedException interrupted) {
        Thread.currentThread().interrupt();
        return false;
      }
    }

    @Override
    public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
      RunsProgram wanted =
          AnnotationSupport.findAnnotation(context.getRequiredTestClass(), RunsProgram.class)
              .orElseThrow();
      Optional<String> missing =
          Arrays.stream(wanted.value()).filter(program -> find(program).isEmpty()).findFirst();
      if (missing.isEmpty() && !imports(wanted.pythonModule())) {
        missing = Optional.of("python3 with " + wanted.pythonModule());
      }
      if (missing.isEmpty()) {
        return ConditionEvaluationResult.enabled("all of its programs are installed");
      }
      String reason =
          context.getDisplayName()
              + " does not run: the program "
              + missing.get()
              + " is not installed; .ci/run installs it";
      LOG.warn(reason);
      return ConditionEvaluationResult.disabled(reason);
    }
  }
}
