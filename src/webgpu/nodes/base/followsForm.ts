/** Whether lines follow the form. @param lineField the choice */
export const followsForm = (lineField: string): boolean => lineField === 'form' || lineField === 'acrossForm';
