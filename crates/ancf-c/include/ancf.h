/*
 * ancf: motions of flexible multibody systems that a program advances step by step.
 *
 * Each function returns a status. After an error, ancf_last_error() is its message, for the calling thread.
 * Texts are in UTF-8. All values are in the units of the model.
 *
 * Generated from the crate ancf-c by cbindgen.
 */

#ifndef ANCF_H
#define ANCF_H

#include <stddef.h>
#include <stdint.h>

/**
 * Result of a function. The message of an error is that of `ancf_last_error`.
 */
typedef enum {
  /**
   * Success.
   */
  ANCF_STATUS_OK = 0,
  /**
   * An argument is not valid: a null pointer, an unknown name, an index or a value out of range. Nothing has changed.
   */
  ANCF_STATUS_ARGUMENT = 1,
  /**
   * The model cannot be read or is not valid, or it has no motion that can be advanced step by step. The message has all errors.
   */
  ANCF_STATUS_MODEL = 2,
  /**
   * The computation failed: time, cause, place and remedy. The state is that of the last accepted substep.
   */
  ANCF_STATUS_FAILED = 3,
  /**
   * The snapshot does not belong to the model, or is damaged. Nothing has changed.
   */
  ANCF_STATUS_SNAPSHOT = 4,
  /**
   * The buffer is too small. The size that is required has been written.
   */
  ANCF_STATUS_BUFFER = 5,
  /**
   * Internal error. The simulation can only be closed.
   */
  ANCF_STATUS_INTERNAL = 6,
} ancf_status;

/**
 * Motion of a model that a program advances step by step. All values are in the units of the model.
 *
 * Simulations are independent. Two threads may use two simulations at the same time, but not the same one.
 */
typedef struct ancf_simulation ancf_simulation;

/**
 * Counts of a step.
 */
typedef struct {
  /**
   * Number of substeps: 1 unless the step was divided at events, by failed iterations or by error control.
   */
  uint32_t substeps;
  /**
   * Number of Newton iterations, including failed attempts.
   */
  uint32_t iterations;
  /**
   * Number of attempts that error control rejected.
   */
  uint32_t rejected;
} ancf_step_report;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * Performs one step of the size h > 0.
 *
 * The step is divided where a load or a drive jumps, and halved if the iteration fails. After `ANCF_STATUS_FAILED` the state is
 * that of the last accepted substep, at `ancf_time`; a smaller step may succeed.
 *
 * @param report Receives the counts; may be NULL.
 *
 * Conditions:
 * `simulation` is open, and `report` is NULL or points to writable memory.
 */
ancf_status ancf_step(ancf_simulation *simulation,
                      double h,
                      ancf_step_report *report);

/**
 * Advances to a time in steps of the model. The last one ends exactly at that time.
 *
 * @param report Receives the sums of the counts; may be NULL.
 *
 * Conditions:
 * `simulation` is open, and `report` is NULL or points to writable memory.
 */
ancf_status ancf_advance(ancf_simulation *simulation, double until, ancf_step_report *report);

/**
 * Present time.
 *
 * Conditions:
 * `simulation` is open, and `time` points to writable memory.
 */
ancf_status ancf_time(ancf_simulation *simulation, double *time);

/**
 * Warnings of all steps so far, one per line; empty if there are none.
 *
 * The text is valid until the next call of this function for the simulation.
 *
 * Conditions:
 * `simulation` is open, and `warnings` points to writable memory.
 */
ancf_status ancf_warnings(ancf_simulation *simulation, const char **warnings);

/**
 * Version of the library, such as `0.2.0`.
 */
const char *ancf_version(void);

/**
 * Reads a model file, checks it, and computes the initial state of its motion.
 *
 * @param path Path of the model file, in UTF-8.
 * @param simulation Receives the simulation, or NULL after an error. `ancf_close` releases it.
 *
 * Conditions:
 * `path` ends with a null character, and `simulation` points to writable memory.
 */
ancf_status ancf_open(const char *path, ancf_simulation **simulation);

/**
 * Reads the text of a model file, as `ancf_open`.
 *
 * @param toml Text of a model file, in UTF-8.
 * @param simulation Receives the simulation, or NULL after an error. `ancf_close` releases it.
 *
 * Conditions:
 * `toml` ends with a null character, and `simulation` points to writable memory.
 */
ancf_status ancf_parse(const char *toml, ancf_simulation **simulation);

/**
 * Releases a simulation. NULL has no effect.
 *
 * Conditions:
 * `simulation` is NULL or a simulation that has not been closed.
 */
void ancf_close(ancf_simulation *simulation);

/**
 * Message of the last error of the calling thread, in UTF-8; empty if there was none.
 *
 * The text is valid until the next call of a function of `ancf` by the thread. Calls without an error keep it.
 */
const char *ancf_last_error(void);

/**
 * Snapshot of everything on which later steps depend. Steps after `ancf_restore` are bit-identical, also in another process.
 *
 * If the buffer is too small or NULL, the result is `ANCF_STATUS_BUFFER`, and `size` is the size that is required. The size may
 * change with each step.
 *
 * @param bytes Buffer of `capacity` bytes, or NULL.
 * @param size Receives the size of the snapshot.
 *
 * Conditions:
 * `simulation` is open, `bytes` is NULL or points to `capacity` writable bytes, and `size` points to writable memory.
 */
ancf_status ancf_save(ancf_simulation *simulation,
                      uint8_t *bytes,
                      size_t capacity,
                      size_t *size);

/**
 * Continues from a snapshot of the same model and the same version.
 *
 * Conditions:
 * `simulation` is open, and `bytes` points to `size` bytes.
 */
ancf_status ancf_restore(ancf_simulation *simulation, const uint8_t *bytes, size_t size);

/**
 * Number of coordinates of the complete state.
 *
 * Conditions:
 * `simulation` is open, and `count` points to writable memory.
 */
ancf_status ancf_count_coordinates(ancf_simulation *simulation, size_t *count);

/**
 * Complete state: coordinates as changes from the reference configuration, and velocities.
 *
 * @param coordinates Receives `count` coordinates.
 * @param velocities Receives `count` velocities.
 *
 * Conditions:
 * `simulation` is open, and the pointers point to writable memory for `count` numbers.
 */
ancf_status ancf_get_state(ancf_simulation *simulation,
                           double *coordinates,
                           double *velocities,
                           size_t count);

/**
 * Continues from another state. Positions and velocities are projected onto the constraints. Angles of hinges and sensors that the
 * coordinates determine up to whole turns are then between −π and π. Inputs keep their values.
 *
 * @param moved Receives the largest displacement of a node or centre by the projection; may be NULL.
 * @param corrected Receives the kinetic energy of the correction of the velocities, relative to that of the given ones; may be NULL.
 *
 * Conditions:
 * `simulation` is open, `coordinates` and `velocities` point to `count` numbers, the other pointers are NULL or point to writable
 * memory.
 */
ancf_status ancf_set_state(ancf_simulation *simulation,
                           double time,
                           const double *coordinates,
                           const double *velocities,
                           size_t count,
                           double *moved,
                           double *corrected);

/**
 * Number of inputs.
 *
 * Conditions:
 * `simulation` is open, and `count` points to writable memory.
 */
ancf_status ancf_count_inputs(ancf_simulation *simulation, size_t *count);

/**
 * Number of columns.
 *
 * Conditions:
 * `simulation` is open, and `count` points to writable memory.
 */
ancf_status ancf_count_columns(ancf_simulation *simulation, size_t *count);

/**
 * Name of an input. The text is valid until the simulation is closed.
 *
 * Conditions:
 * `simulation` is open, and `name` points to writable memory.
 */
ancf_status ancf_input_name(ancf_simulation *simulation, size_t input, const char **name);

/**
 * Name of a column, such as `tip.y`. The text is valid until the simulation is closed.
 *
 * Conditions:
 * `simulation` is open, and `name` points to writable memory.
 */
ancf_status ancf_column_name(ancf_simulation *simulation, size_t column, const char **name);

/**
 * Unit of a column, such as `mm`; empty if the model names no units. The text is valid until the simulation is closed.
 *
 * Conditions:
 * `simulation` is open, and `unit` points to writable memory.
 */
ancf_status ancf_column_unit(ancf_simulation *simulation,
                             size_t column,
                             const char **unit);

/**
 * Finds an input by its name.
 *
 * Conditions:
 * `simulation` is open, `name` ends with a null character, and `input` points to writable memory.
 */
ancf_status ancf_find_input(ancf_simulation *simulation, const char *name, size_t *input);

/**
 * Finds a column by its name.
 *
 * Conditions:
 * `simulation` is open, `name` ends with a null character, and `column` points to writable memory.
 */
ancf_status ancf_find_column(ancf_simulation *simulation, const char *name, size_t *column);

/**
 * Value of an input: the one last set, or the present value during a ramp.
 *
 * Conditions:
 * `simulation` is open, and `value` points to writable memory.
 */
ancf_status ancf_get_input(ancf_simulation *simulation, size_t input, double *value);

/**
 * Sets an input from the present time on.
 *
 * The next step starts with the value. Until then, values that are read are those before the jump.
 *
 * @param ramp Duration of a linear transition from the present value; 0 is a jump. An input that prescribes a position must not jump.
 *
 * Conditions:
 * `simulation` is open.
 */
ancf_status ancf_set_input(ancf_simulation *simulation,
                           size_t input,
                           double value,
                           double ramp);

/**
 * Value of a column in the present state.
 *
 * Conditions:
 * `simulation` is open, and `value` points to writable memory.
 */
ancf_status ancf_read(ancf_simulation *simulation, size_t column, double *value);

/**
 * Values of all columns in the present state.
 *
 * @param values Receives `count` values.
 * @param count Number of columns.
 *
 * Conditions:
 * `simulation` is open, and `values` points to writable memory for `count` numbers.
 */
ancf_status ancf_read_row(ancf_simulation *simulation, double *values, size_t count);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* ANCF_H */
